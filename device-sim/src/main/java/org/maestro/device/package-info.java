/**
 * Devices as members of the RATS bus: what a device's description promises, carried out by its
 * drivers (the domain layer). Calls flow in, driver commands, results and facts about the device
 * itself flow out. A task's local plan is made and kept here (Three-layered architecture, 2; M18,
 * M19). It knows the keys of procedures, parameters and quantities, never a word of the domain, and
 * nothing of the simulation.
 */
@NullMarked
package org.maestro.device;

import org.jspecify.annotations.NullMarked;
