/**
 * What the rest of MAESTRO says to coordination and hears from it: goals and how they end, and the
 * ports through which knowledge, planning, prices, orders, journal and story are reached. Goals,
 * bids and reports flow in as these types; orders, entries and sentences flow out. It knows no
 * other part of coordination; with the Coordinator and what a journal amounts to it is all that
 * others see.
 */
@NullMarked
package org.maestro.coordination.api;

import org.jspecify.annotations.NullMarked;
