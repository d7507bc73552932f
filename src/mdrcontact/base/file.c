/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * Whole files, read and written from any number of threads. (Fortran's own statements refuse a file that another unit has open,
 * end a name at its trailing blanks, and write in place.)
 *
 * A file is written beside its place, flushed and then moved there: a reader of the name finds the old content or the new, and a
 * full disk costs nothing but an error. Its owner and its mode stay. A symbolic link is followed, its target replaced. What exists
 * and is not a regular file (a folder, a device, a pipe) or is write-protected is left alone.
 *
 * Where no file can take the place of another, as that has further names (hard links), its folder is write-protected, or its owner
 * could not stay, it is written in place: then a program that is killed leaves a part, which its checksum shows.
 *
 * A program that is killed before leaves the file beside. Who writes it holds a lock on it, which the system takes from a process
 * that ends: the next one to write into the folder removes what is not locked.
 */
#define _POSIX_C_SOURCE 200809L
#define _DEFAULT_SOURCE /* flock */
#define _DARWIN_C_SOURCE
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MOST_LINKS = 40, MOST_TRIALS = 100000, NAME_SPACE = 64 };

static const char *const not_regular = "it is not a regular file";

int mdrcontact_open_file(const char *path, long long *size, char *reason, size_t space);
int mdrcontact_read_file(int file, char *bytes, size_t size, char *reason, size_t space);
int mdrcontact_write_file(const char *path, const char *bytes, size_t size, char *reason, size_t space);

static int refuse(char *reason, size_t space, const char *words)
{
    snprintf(reason, space, "%s", words);
    return -1;
}

static int refuse_by_system(char *reason, size_t space, int number)
{
    if (strerror_r(number, reason, space) != 0) snprintf(reason, space, "error %d of the system", number);
    return -1;
}

/* Opens a regular file for reading; the descriptor, or -1 and the reason. Only called from Fortran, like the next two. */
int mdrcontact_open_file(const char *path, long long *size, char *reason, size_t space)
{
    struct stat facts;
    /* a pipe without a writer would wait for ever */
    const int file = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);

    if (file < 0) return refuse_by_system(reason, space, errno);
    if (fstat(file, &facts) != 0) {
        refuse_by_system(reason, space, errno);
    } else if (!S_ISREG(facts.st_mode)) {
        refuse(reason, space, not_regular);
    } else {
        *size = (long long)facts.st_size;
        return file;
    }
    close(file);
    return -1;
}

/* Reads `size` bytes and closes; 0, or -1 and the reason. With `bytes` NULL it closes only. */
int mdrcontact_read_file(int file, char *bytes, size_t size, char *reason, size_t space)
{
    int status = 0;

    for (size_t done = 0; bytes && status == 0 && done < size;) {
        const ssize_t count = read(file, bytes + done, size - done);
        if (count > 0) {
            done += (size_t)count;
        } else if (count == 0) {
            status = refuse(reason, space, "it became shorter while it was read");
        } else if (errno != EINTR) {
            status = refuse_by_system(reason, space, errno);
        }
    }
    close(file);
    return status;
}

/* The length of the folder in a path, its last slash included. */
static size_t folder_length(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? (size_t)(slash - path) + 1 : 0;
}

/* Path of what a symbolic link points to, as seen from the folder of the link; NULL with errno. Frees the link's path. */
static char *follow(char *link, const struct stat *facts)
{
    const size_t folder = folder_length(link), space = (size_t)(facts->st_size > 0 ? facts->st_size : 4096) + 1;
    char *target = malloc(folder + space);
    const ssize_t count = target ? readlink(link, target + folder, space - 1) : -1;

    if (count < 0 || (size_t)count == space - 1 + (facts->st_size > 0)) {
        free(target);
        target = NULL;
    } else {
        target[folder + (size_t)count] = '\0';
        if (target[folder] == '/') {
            memmove(target, target + folder, (size_t)count + 1);
        } else {
            memcpy(target, link, folder);
        }
    }
    free(link);
    return target;
}

/* The file that a path means in the end, to be freed, and what it is, if it exists; NULL and the reason where nothing may be
 * written. */
static char *place_of(const char *path, struct stat *found, char *reason, size_t space)
{
    struct stat facts;
    char *place = strdup(path);

    for (int links = 0; place && links < MOST_LINKS; links++) {
        if (lstat(place, &facts) != 0) {
            if (errno == ENOENT) return place; /* a new file; or no such folder, which opening it shows */
            refuse_by_system(reason, space, errno);
            free(place);
            return NULL;
        }
        if (S_ISLNK(facts.st_mode)) {
            place = follow(place, &facts);
            continue;
        }
        *found = facts;
        if (S_ISREG(facts.st_mode) && access(place, W_OK) == 0) return place;
        if (S_ISREG(facts.st_mode)) {
            refuse_by_system(reason, space, errno);
        } else {
            refuse(reason, space, not_regular);
        }
        free(place);
        return NULL;
    }
    refuse_by_system(reason, space, place ? ELOOP : errno);
    free(place);
    return NULL;
}

static const char *const beside_name = ".mdrcontact-%ld-%d.tmp";

/* Whether a name is that of a file beside. */
static int is_beside(const char *name)
{
    long process;
    int trial, length = 0;
    return sscanf(name, ".mdrcontact-%ld-%d.tmp%n", &process, &trial, &length) == 2 && length > 0 && name[length] == '\0';
}

/* Removes a file that nobody locks. */
static void remove_abandoned(int folder, const char *name)
{
    struct stat facts;
    const int file = openat(folder, name, O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);

    if (file < 0) return;
    if (fstat(file, &facts) == 0 && S_ISREG(facts.st_mode) && facts.st_uid == geteuid() && flock(file, LOCK_EX | LOCK_NB) == 0) {
        unlinkat(folder, name, 0);
    }
    close(file);
}

/* Removes what killed programs have left in the folder of `place`. */
static void clear_folder(const char *place)
{
    const size_t length = folder_length(place);
    char *path = malloc(length + 2);
    DIR *folder = NULL;

    if (path) {
        memcpy(path, place, length);
        memcpy(path + length, length > 0 ? "" : ".", length > 0 ? 1 : 2);
        folder = opendir(path);
    }
    for (struct dirent *entry; folder && (entry = readdir(folder)) != NULL;) {
        if (is_beside(entry->d_name)) remove_abandoned(dirfd(folder), entry->d_name);
    }
    if (folder) closedir(folder);
    free(path);
}

/* Opens and locks a new file beside `place`, whose name goes to `beside` (the length of `place` and NAME_SPACE more); -1 with
 * errno. */
static int open_beside(const char *place, char *beside)
{
    const size_t folder = folder_length(place);
    struct stat facts;
    int file = -1;

    memcpy(beside, place, folder);
    for (int i = 0; file < 0 && i < MOST_TRIALS; i++) {
        snprintf(beside + folder, NAME_SPACE, beside_name, (long)getpid(), i);
        file = open(beside, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (file < 0 && errno != EEXIST) break;
        if (file < 0) continue;
        /* another process may have locked it first, to remove it; where files have no locks nobody does */
        if ((flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) || fstat(file, &facts) != 0 || facts.st_nlink == 0) {
            close(file);
            file = -1;
        }
    }
    return file;
}

/* Writes everything and sees it to the disk; errno of what went wrong, or 0. */
static int write_all(int file, const char *bytes, size_t size)
{
    int problem = 0;

    for (size_t done = 0; problem == 0 && done < size;) {
        const ssize_t count = write(file, bytes + done, size - done);
        if (count >= 0) {
            done += (size_t)count;
        } else if (errno != EINTR) {
            problem = errno;
        }
    }
    /* some file systems find out that they are full here; EINVAL: this one does not flush */
    if (problem == 0 && fsync(file) != 0 && errno != EINVAL) problem = errno;
    return problem;
}

/* Gives a new file the owner and the mode of the old one; 0 if its owner has to change. */
static int adopt(int file, const struct stat *old)
{
    struct stat facts;

    if (fstat(file, &facts) != 0) return 0;
    if ((facts.st_uid != old->st_uid || facts.st_gid != old->st_gid) && fchown(file, old->st_uid, old->st_gid) != 0) return 0;
    fchmod(file, old->st_mode & 07777);
    return 1;
}

/* Writes over a file; errno, or 0. */
static int write_in_place(const char *place, const char *bytes, size_t size)
{
    const int file = open(place, O_WRONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    int problem = file < 0 ? errno : write_all(file, bytes, size);

    if (problem == 0 && ftruncate(file, (off_t)size) != 0) problem = errno;
    if (file >= 0 && close(file) != 0 && problem == 0) problem = errno;
    return problem;
}

/* Writes a file beside `place` and moves it there; errno, or 0. `old` has no link if there is no old file; `stays` becomes 1 if
 * that has to be written in place. */
static int replace(const char *place, const struct stat *old, const char *bytes, size_t size, int *stays)
{
    char *beside = malloc(strlen(place) + NAME_SPACE);
    int file = -1, problem = 0;

    if (!beside) return ENOMEM;
    file = open_beside(place, beside);
    if (file < 0) {
        problem = errno;
        *stays = old->st_nlink > 0 && (problem == EACCES || problem == EPERM || problem == EROFS);
    } else {
        if (old->st_nlink > 0) *stays = !adopt(file, old);
        if (!*stays) problem = write_all(file, bytes, size);
        if (!*stays && problem == 0 && rename(beside, place) != 0) {
            problem = errno;
            *stays = old->st_nlink > 0 && (problem == EACCES || problem == EPERM || problem == EBUSY);
        }
        if (*stays || problem != 0) unlink(beside);
        close(file);
    }
    free(beside);
    return problem;
}

/* Makes the file `path` with these bytes, or replaces it; 0, or -1 and the reason. */
int mdrcontact_write_file(const char *path, const char *bytes, size_t size, char *reason, size_t space)
{
    struct stat old;
    char *place;
    int problem = 0, stays;

    memset(&old, 0, sizeof old);
    place = place_of(path, &old, reason, space);
    if (!place) return -1;
    clear_folder(place);
    stays = old.st_nlink > 1;
    if (!stays) problem = replace(place, &old, bytes, size, &stays);
    if (stays) problem = write_in_place(place, bytes, size);
    free(place);
    return problem == 0 ? 0 : refuse_by_system(reason, space, problem);
}
