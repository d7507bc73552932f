/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An mdr_cancel for the interpreter's main thread: its address is `_native.interrupted`. */
#include <Python.h>

int interrupted(void *unused);

/* Lets Python answer signals, and stops the call if that raised, as Ctrl-C does; f2py then passes the exception on. */
int interrupted(void *unused)
{
    PyGILState_STATE state = PyGILState_Ensure();
    const int answer = PyErr_Occurred() != NULL || PyErr_CheckSignals() != 0;
    (void)unused;
    PyGILState_Release(state);
    return answer;
}
