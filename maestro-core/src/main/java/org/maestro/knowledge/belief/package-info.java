/**
 * What is believed, drawn from what is claimed: claims weighed by sureness and time, positions and
 * what follows from them, ageing. Claims flow in; settled beliefs, disputes and what is too old
 * flow out. Immutable but for a draft; it knows no RDF.
 */
@NullMarked
package org.maestro.knowledge.belief;

import org.jspecify.annotations.NullMarked;
