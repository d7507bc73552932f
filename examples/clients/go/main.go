// SPDX-License-Identifier: GPL-3.0-or-later

// Go: a law is compiled once, and goroutines share it. Built with PKG_CONFIG_PATH at the library, go run .
//
// The words of a failure belong to the thread that failed, and Go may move a goroutine to another thread between two calls of C:
// `call` holds the goroutine to its thread until it has fetched them.
//
// Checks: Hertz's force; the same bits in all goroutines; a refusal with its own words in each of them.
package main

/*
#cgo pkg-config: mdrcontact
#include <mdrcontact_law.h>
#include <stdlib.h>
*/
import "C"

import (
	"errors"
	"fmt"
	"math"
	"os"
	"runtime"
	"strings"
	"sync"
	"unsafe"
)

// call turns a failure of f into an error with the library's words.
func call(f func() C.int) error {
	runtime.LockOSThread()
	defer runtime.UnlockOSThread()
	if f() == C.MDR_SUCCESS {
		return nil
	}
	return errors.New(C.GoString(C.mdr_last_error()))
}

func must(err error) {
	if err != nil {
		fmt.Fprintln(os.Stderr, err)
		os.Exit(1)
	}
}

func newLaw(radius, modulus, nu, depth float64) *C.mdr_law {
	var ball *C.mdr_profile
	var plate *C.mdr_body
	var medium *C.mdr_medium
	var contact *C.mdr_contact
	var law *C.mdr_law
	must(call(func() C.int { return C.mdr_profile_paraboloid(C.double(radius), &ball) }))
	glass := C.mdr_isotropic(C.double(modulus), C.double(nu), 0)
	must(call(func() C.int { return C.mdr_body_layered(0, nil, &glass, nil, &plate) }))
	must(call(func() C.int { return C.mdr_medium_new(plate, nil, &medium) }))
	must(call(func() C.int { return C.mdr_contact_new(ball, medium, nil, &contact) }))
	must(call(func() C.int { return C.mdr_law_new(contact, C.double(depth), nil, &law) }))
	must(call(func() C.int { return C.mdr_free(unsafe.Pointer(contact)) }))
	must(call(func() C.int { return C.mdr_free(unsafe.Pointer(medium)) }))
	must(call(func() C.int { return C.mdr_free(unsafe.Pointer(plate)) }))
	must(call(func() C.int { return C.mdr_free(unsafe.Pointer(ball)) }))
	return law
}

// force is F at a depth.
func force(law *C.mdr_law, depth float64) (float64, error) {
	var F C.double
	err := call(func() C.int { return C.mdr_law_force(law, C.MDR_ON_UNLOADING, C.double(depth), &F, nil) })
	return float64(F), err
}

func main() {
	const radius, modulus, nu, depth, many = 1e-5, 72e9, 0.17, 1e-7, 64
	law := newLaw(radius, modulus, nu, 2*depth)
	hertz := 4.0 / 3.0 * modulus / (1 - nu*nu) * math.Sqrt(radius) * math.Pow(depth, 1.5)
	one, err := force(law, depth)
	must(err)
	var group sync.WaitGroup
	wrong := make([]string, many)
	for i := 0; i < many; i++ {
		group.Add(1)
		go func(i int) {
			defer group.Done()
			for j := 0; j < 1000; j++ {
				if again, err := force(law, depth); err != nil || again != one {
					wrong[i] = "another force"
				}
				tooDeep := fmt.Sprintf("%d", i+2) // m
				if _, err := force(law, float64(i+2)); err == nil || !strings.Contains(err.Error(), " = "+tooDeep+": ") {
					wrong[i] = fmt.Sprintf("the words of another goroutine: %v", err)
				}
				runtime.Gosched()
			}
		}(i)
	}
	group.Wait()
	must(call(func() C.int { return C.mdr_free(unsafe.Pointer(law)) }))
	for _, words := range wrong {
		if words != "" {
			must(errors.New(words))
		}
	}
	largest := math.Abs(one/hertz - 1)
	fmt.Printf("F = %.4f mN, largest relative error %.1e; %d goroutines with the same bits and words of their own\n", one*1e3, largest, many)
	if largest > 1e-9 {
		os.Exit(1)
	}
}
