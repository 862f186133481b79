/**
 * The device side of RATS: the runtime that turns procedures of a device into a member of the bus,
 * with identity, states, queue, safe states and costs. Calls flow in, outcomes, states and
 * observations flow out. It knows neither MAESTRO nor what the device is.
 */
@NullMarked
package org.maestro.rats.member;

import org.jspecify.annotations.NullMarked;
