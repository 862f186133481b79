/**
 * An examination of one device on a bus, by whomever it was made: calls it as a platform would, and
 * as nobody should, and tells for each rule of the bus whether the device keeps it. The device's
 * messages flow in, findings out. It knows the protocol only, neither words of a home nor our own
 * members.
 */
@NullMarked
package org.maestro.rats.conformance;

import org.jspecify.annotations.NullMarked;
