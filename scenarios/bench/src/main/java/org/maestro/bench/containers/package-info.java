/**
 * Benchmarks of many: agents in one process, containers of as many hosts, and sites that open again
 * and again. How many flows in; time, memory and processor time part by part flow out.
 */
@NullMarked
package org.maestro.bench.containers;

import org.jspecify.annotations.NullMarked;
