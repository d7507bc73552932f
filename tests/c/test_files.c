/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Files of laws: a full disk, threads, names with blanks, links, and what is not a regular file. POSIX. */
#define _XOPEN_SOURCE 700
#include "check.h"

#include <dirent.h>
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

/* Each round waits for the disk. */
enum { THREADS = 4, ROUNDS = 12 };

static mdr_law *law;
static const char *const shared_name = "shared.mdrlaw";

static mdr_law *new_law(double radius)
{
    mdr_profile *ball = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;
    mdr_law *made = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(radius, &ball));
    CHECK_SUCCESS(new_homogeneous(1.0, 0.3, &medium));
    CHECK_SUCCESS(mdr_contact_new(ball, medium, NULL, &contact));
    CHECK_SUCCESS(mdr_law_new(contact, 0.1, NULL, &made));
    CHECK_FREE(contact);
    CHECK_FREE(medium);
    CHECK_FREE(ball);
    return made;
}

/* Force at one depth of the law in a file; -1 if it cannot be loaded. */
static double force_from(const char *path)
{
    mdr_law *loaded = NULL;
    double F = -1.0;

    if (mdr_law_load(path, &loaded) != MDR_SUCCESS) return -1.0;
    mdr_law_force(loaded, MDR_ON_UNLOADING, 0.05, &F, NULL);
    MDR_FREE(loaded);
    return F;
}

static void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    CHECK_TRUE(file != NULL);
    if (!file) return;
    fputs(text, file);
    fclose(file);
}

static void check_text_in(const char *path, const char *expected)
{
    char text[64] = "";
    FILE *file = fopen(path, "r");
    CHECK_TRUE(file != NULL);
    if (!file) return;
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    CHECK_TEXT(text, expected);
}

/* How many entries this folder has: nothing may be left behind. */
static int entries(void)
{
    DIR *folder = opendir(".");
    int count = 0;
    while (folder && readdir(folder)) count++;
    if (folder) closedir(folder);
    return count;
}

static void test_full_disk(void)
{
    struct rlimit limit, full;

    signal(SIGXFSZ, SIG_IGN);
    getrlimit(RLIMIT_FSIZE, &limit);
    full = limit;
    full.rlim_cur = 1000; /* a file may grow to this size and no further */
    CHECK_SUCCESS(mdr_law_save(law, "kept"));
    write_text("other", "other");
    const int before = entries();
    setrlimit(RLIMIT_FSIZE, &full);
    const int status = mdr_law_save(law, "kept"), status_other = mdr_law_save(law, "other"), status_new = mdr_law_save(law, "new");
    setrlimit(RLIMIT_FSIZE, &limit);
    CHECK_STATUS(status, MDR_EFILE, "cannot be written");
    CHECK_INT(status_other, MDR_EFILE);
    CHECK_INT(status_new, MDR_EFILE);
    CHECK_INT(entries(), before);
    CHECK_TRUE(force_from("kept") > 0.0);
    check_text_in("other", "other");
    remove("kept");
    remove("other");
}

static void *save_and_load(void *failures)
{
    for (int i = 0; i < ROUNDS; i++) {
        if (mdr_law_save(law, shared_name) != MDR_SUCCESS) ++*(int *)failures;
        if (force_from(shared_name) < 0.0) ++*(int *)failures;
    }
    return NULL;
}

static void test_threads(void)
{
    pthread_t threads[THREADS];
    int failures[THREADS] = {0};
    const int before = entries();

    for (int i = 0; i < THREADS; i++) pthread_create(&threads[i], NULL, save_and_load, &failures[i]);
    for (int i = 0; i < THREADS; i++) {
        pthread_join(threads[i], NULL);
        CHECK_INT(failures[i], 0);
    }
    remove(shared_name);
    CHECK_INT(entries(), before);
}

static void test_names(void)
{
    mdr_law *larger = new_law(2.0);

    CHECK_SUCCESS(mdr_law_save(law, "name"));
    CHECK_SUCCESS(mdr_law_save(larger, "name "));
    CHECK_TRUE(force_from("name") > 0.0 && force_from("name ") > 1.2 * force_from("name"));
    remove("name");
    CHECK_STATUS(mdr_law_load("name", &larger), MDR_EFILE, "the file name cannot be read");
    remove("name ");
    CHECK_FREE(larger);
}

static void test_links(void)
{
    struct stat facts;

    mkdir("folder", 0777);
    write_text("folder/target", "old");
    chmod("folder/target", 0640);
    CHECK_INT(symlink("folder/target", "link"), 0);
    CHECK_INT(symlink("../link", "folder/link_to_link"), 0);
    CHECK_INT(symlink("folder/new", "link_to_nothing"), 0);
    CHECK_INT(symlink("circle", "circle"), 0);
    CHECK_SUCCESS(mdr_law_save(law, "folder/link_to_link"));
    CHECK_TRUE(lstat("link", &facts) == 0 && S_ISLNK(facts.st_mode));
    CHECK_TRUE(lstat("folder/link_to_link", &facts) == 0 && S_ISLNK(facts.st_mode));
    CHECK_TRUE(lstat("folder/target", &facts) == 0 && S_ISREG(facts.st_mode));
    CHECK_INT((int)(facts.st_mode & 07777), 0640);
    CHECK_TRUE(force_from("folder/target") > 0.0);
    CHECK_SUCCESS(mdr_law_save(law, "link_to_nothing"));
    CHECK_TRUE(force_from("folder/new") > 0.0);
    CHECK_STATUS(mdr_law_save(law, "circle"), MDR_EFILE, "cannot be written");
    remove("circle");
    remove("link_to_nothing");
    remove("folder/new");
    remove("folder/link_to_link");
    remove("link");
    remove("folder/target");
    CHECK_INT(rmdir("folder"), 0);
}

static void test_not_regular(void)
{
    mdr_law *loaded = NULL;
    struct stat facts;

    CHECK_INT(mkfifo("pipe", 0666), 0);
    CHECK_STATUS(mdr_law_save(law, "pipe"), MDR_EFILE, "not a regular file");
    CHECK_STATUS(mdr_law_load("pipe", &loaded), MDR_EFILE, "not a regular file");
    CHECK_TRUE(lstat("pipe", &facts) == 0 && S_ISFIFO(facts.st_mode));
    remove("pipe");
    CHECK_STATUS(mdr_law_load("/dev/zero", &loaded), MDR_EFILE, "not a regular file");
    CHECK_STATUS(mdr_law_save(law, "."), MDR_EFILE, "not a regular file");
    CHECK_STATUS(mdr_law_load(".", &loaded), MDR_EFILE, "not a regular file");
    CHECK_STATUS(mdr_law_save(law, ""), MDR_EFILE, "cannot be written");
    CHECK_TRUE(loaded == NULL);
}

int main(void)
{
    char folder[] = "test_files_XXXXXX";

    CHECK_TRUE(mkdtemp(folder) != NULL && chdir(folder) == 0);
    law = new_law(1.0);
    test_full_disk();
    test_threads();
    test_names();
    test_links();
    test_not_regular();
    CHECK_FREE(law);
    CHECK_TRUE(chdir("..") == 0 && rmdir(folder) == 0);
    return check_report("files");
}
