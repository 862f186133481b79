/**
 * Ways over the floor for a round body: free floor among walls and obstacles, and the shortest way
 * by a visibility graph. Outlines and obstacles flow in; routes flow out. It knows neither drivers
 * nor calls.
 */
@NullMarked
package org.maestro.device.navigation;

import org.jspecify.annotations.NullMarked;
