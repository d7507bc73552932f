/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A host that is killed while it saves a law, 150 times, at different moments: the file is always one of the two laws, and what the
 * killed ones left is gone after the next save. Then files that no other file can take the place of, and paths longer than a text.
 */
#define _XOPEN_SOURCE 700
#define _DEFAULT_SOURCE /* usleep */
#include "../c/check.h"

#include <dirent.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum { KILLS = 150, LONG_PATH = 1800 };

static mdr_law *new_law(double radius)
{
    const mdr_layer soft = mdr_isotropic(1.0, 0.3, 0.0);
    mdr_profile *ball = NULL;
    mdr_body *body = NULL;
    mdr_medium *medium = NULL;
    mdr_contact *contact = NULL;
    mdr_law *law = NULL;

    CHECK_SUCCESS(mdr_profile_paraboloid(radius, &ball));
    CHECK_SUCCESS(mdr_body_layered(0, NULL, &soft, NULL, &body));
    CHECK_SUCCESS(mdr_medium_new(body, NULL, &medium));
    CHECK_SUCCESS(mdr_contact_new(ball, medium, NULL, &contact));
    CHECK_SUCCESS(mdr_law_new(contact, 0.1, NULL, &law));
    CHECK_FREE(contact);
    CHECK_FREE(medium);
    CHECK_FREE(body);
    CHECK_FREE(ball);
    return law;
}

/* Files in this folder that a save has left. */
static int left_behind(void)
{
    DIR *folder = opendir(".");
    int count = 0;
    for (struct dirent *entry; folder && (entry = readdir(folder)) != NULL;) {
        count += strncmp(entry->d_name, ".mdrcontact-", 12) == 0;
    }
    if (folder) closedir(folder);
    return count;
}

static double force_from(const char *path)
{
    mdr_law *loaded = NULL;
    double F = -1.0;
    if (mdr_law_load(path, &loaded) != MDR_SUCCESS) return -1.0;
    mdr_law_force(loaded, MDR_ON_UNLOADING, 0.05, &F, NULL);
    MDR_FREE(loaded);
    return F;
}

static void kill_while_saving(const mdr_law *one, const mdr_law *other, double first, double second)
{
    int damaged = 0;

    CHECK_SUCCESS(mdr_law_save(one, "killed.law"));
    for (int i = 0; i < KILLS; i++) {
        const pid_t child = fork();
        if (child == 0) {
            for (;;) {
                mdr_law_save(other, "killed.law");
                mdr_law_save(one, "killed.law");
            }
        }
        usleep((useconds_t)(500 + 97 * i));
        kill(child, SIGKILL);
        waitpid(child, NULL, 0);
        const double F = force_from("killed.law");
        damaged += !(F == first || F == second);
    }
    CHECK_INT(damaged, 0);
    CHECK_SUCCESS(mdr_law_save(one, "killed.law"));
    CHECK_INT(left_behind(), 0);
    CHECK_TRUE(force_from("killed.law") == first);
}

/* Another process writes meanwhile: what it has begun stays. */
static void keep_what_others_write(const mdr_law *one, const mdr_law *other)
{
    int failed = 0, status = 0;
    const pid_t child = fork();

    if (child == 0) {
        for (int i = 0; i < 40; i++) failed += mdr_law_save(other, "theirs.law") != MDR_SUCCESS;
        _exit(failed > 0);
    }
    for (int i = 0; i < 40; i++) failed += mdr_law_save(one, "ours.law") != MDR_SUCCESS;
    waitpid(child, &status, 0);
    CHECK_INT(failed, 0);
    CHECK_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0);
    CHECK_INT(left_behind(), 0);
}

static void write_in_place(const mdr_law *one, const mdr_law *other, double first, double second)
{
    struct stat before, after;

    CHECK_SUCCESS(mdr_law_save(one, "name.law"));
    CHECK_INT(link("name.law", "second.law"), 0);
    CHECK_INT(stat("name.law", &before), 0);
    CHECK_SUCCESS(mdr_law_save(other, "name.law"));
    CHECK_INT(stat("name.law", &after), 0);
    CHECK_TRUE(before.st_ino == after.st_ino && after.st_nlink == 2);
    CHECK_TRUE(force_from("second.law") == second);

    CHECK_INT(mkdir("locked", 0700), 0);
    CHECK_SUCCESS(mdr_law_save(one, "locked/one.law"));
    CHECK_INT(chmod("locked", 0500), 0);
    CHECK_SUCCESS(mdr_law_save(other, "locked/one.law"));
    CHECK_TRUE(force_from("locked/one.law") == second);
    CHECK_INT(chmod("locked", 0700), 0);

    CHECK_SUCCESS(mdr_law_save(one, "owned.law"));
    CHECK_INT(chmod("owned.law", 0646), 0);
    if (geteuid() == 0) CHECK_INT(chown("owned.law", 12345, 54321), 0);
    CHECK_INT(stat("owned.law", &before), 0);
    CHECK_SUCCESS(mdr_law_save(other, "owned.law"));
    CHECK_INT(stat("owned.law", &after), 0);
    CHECK_TRUE(before.st_uid == after.st_uid && before.st_gid == after.st_gid && before.st_mode == after.st_mode);
    CHECK_TRUE(force_from("owned.law") == second && first != second);
}

static void say_why(const mdr_law *law)
{
    char path[LONG_PATH + 1];
    mdr_law *loaded = NULL;

    for (int i = 0; i < LONG_PATH; i++) path[i] = (char)(i % 100 == 99 ? '/' : 'a');
    path[LONG_PATH] = '\0';
    CHECK_STATUS(mdr_law_save(law, path), MDR_EFILE, "No such file or directory");
    CHECK_STATUS(mdr_law_load(path, &loaded), MDR_EFILE, "No such file or directory");
}

int main(void)
{
    mdr_law *one = new_law(1.0), *other = new_law(2.0);
    char folder[] = "kills.XXXXXX";
    double first = 0.0, second = 0.0;

    CHECK_TRUE(mkdtemp(folder) != NULL && chdir(folder) == 0);
    CHECK_SUCCESS(mdr_law_force(one, MDR_ON_UNLOADING, 0.05, &first, NULL));
    CHECK_SUCCESS(mdr_law_force(other, MDR_ON_UNLOADING, 0.05, &second, NULL));
    kill_while_saving(one, other, first, second);
    keep_what_others_write(one, other);
    write_in_place(one, other, first, second);
    say_why(one);
    CHECK_FREE(one);
    CHECK_FREE(other);
    CHECK_INT(chdir(".."), 0);
    {
        char command[64];
        snprintf(command, sizeof command, "rm -r %s", folder);
        CHECK_INT(system(command), 0);
    }
    return check_report("kills");
}
