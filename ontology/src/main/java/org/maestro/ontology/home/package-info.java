/**
 * The typed read model of a home, and what follows from where things in it are: rooms, zones,
 * doors, things and devices. Home files and device descriptions flow in, immutable records and
 * geometric values flow out. Geometry asks for properties (pose, view angle, luminous intensity),
 * never for a kind of device.
 */
@NullMarked
package org.maestro.ontology.home;

import org.jspecify.annotations.NullMarked;
