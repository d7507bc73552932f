/* SPDX-License-Identifier: GPL-3.0-or-later */
/*
 * A law at one depth for Python, or None where there is more to be said than numbers: f2py's way through arrays costs a hundred times
 * the force itself. wrap_header.py puts these functions into the module that f2py writes.
 */
#define PY_SSIZE_T_CLEAN
#include <Python.h>

#include "mdrcontact_law.h"

PyObject *law_force_scalar(PyObject *self, PyObject *const *given, Py_ssize_t count);
PyObject *law_state_scalar(PyObject *self, PyObject *const *given, Py_ssize_t count);

/* The law of a `Handle` of _boundary.py, which the arguments of the caller keep; NULL with an exception. */
static const mdr_law *law_of(PyObject *handle)
{
    static PyObject *name = NULL; /* made once, under the interpreter's lock: twice as quick as from a C string */
    const mdr_law *law = NULL;
    PyObject *address;
    if (!name) name = PyUnicode_InternFromString("_address");
    address = name ? PyObject_GetAttr(handle, name) : NULL;
    if (address) law = (const mdr_law *)PyLong_AsVoidPtr(address);
    Py_XDECREF(address);
    return law;
}

/* law_force_scalar(law, branch, d): F. */
PyObject *law_force_scalar(PyObject *self, PyObject *const *given, Py_ssize_t count)
{
    double F;
    (void)self;
    if (count == 3 && PyLong_Check(given[1]) && PyFloat_Check(given[2])) {
        const mdr_law *law = law_of(given[0]);
        if (mdr_law_force(law, (int)PyLong_AsLong(given[1]), PyFloat_AS_DOUBLE(given[2]), &F, NULL) == MDR_SUCCESS) {
            return PyFloat_FromDouble(F);
        }
    }
    if (PyErr_Occurred()) return NULL;
    Py_RETURN_NONE;
}

/* law_state_scalar(law, branch, d): d, a, F, k, slope. */
PyObject *law_state_scalar(PyObject *self, PyObject *const *given, Py_ssize_t count)
{
    mdr_law_point p;
    mdr_law_view view;
    (void)self;
    if (count == 3 && PyLong_Check(given[1]) && PyFloat_Check(given[2])) {
        const mdr_law *law = law_of(given[0]);
        if (mdr_law_view_of(law, (int)PyLong_AsLong(given[1]), &view) == MDR_SUCCESS
            && mdr_law_view_state(&view, PyFloat_AS_DOUBLE(given[2]), &p) == MDR_SUCCESS) {
            const double values[] = {p.depth, p.radius, p.force, p.stiffness, p.slope};
            PyObject *state = PyTuple_New(5); /* many times as quick as Py_BuildValue */
            for (Py_ssize_t i = 0; state && i < 5; ++i) {
                PyObject *value = PyFloat_FromDouble(values[i]);
                if (value) PyTuple_SET_ITEM(state, i, value);
                else Py_CLEAR(state);
            }
            return state;
        }
    }
    if (PyErr_Occurred()) return NULL;
    Py_RETURN_NONE;
}
