/* SPDX-License-Identifier: GPL-3.0-or-later */
/**
 * @file all.h
 * The core, mdrcontact.h, and all extensions.
 */
#ifndef MDRCONTACT_ALL_H
#define MDRCONTACT_ALL_H

#include "../mdrcontact.h"
#include "time.h"
#include "adhesion.h"
#include "wear.h"
#include "conduction.h"
#include "poroelastic.h"
#include "plastic.h"
#include "lateral.h"
#include "fit.h"

#endif
