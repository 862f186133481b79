/**
 * Which agent stands for which devices, how it was started, and where (Three-layered architecture,
 * 3.3.2; M68-M72). Starts of agents and containers flow in; places for agents, objections in one
 * sentence, and tables flow out. Plain Java: it may not know JADE, and moves nothing itself.
 */
@NullMarked
package org.maestro.deployment;

import org.jspecify.annotations.NullMarked;
