/**
 * How well the persons of a home are followed: seeded evenings on whole sites, in which persons
 * walk about, and what is told of them held against where they truly are. A home flows in, rows of
 * figures flow out. It judges by what anybody can ask, not by the tracker's own numbers.
 */
@NullMarked
package org.maestro.bench.tracking;

import org.jspecify.annotations.NullMarked;
