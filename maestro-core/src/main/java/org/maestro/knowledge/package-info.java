/**
 * The collective knowledge base (Three-layered architecture, 2; M12): facts with source and age
 * over an RDF dataset, true, false or unknown. Descriptions, results, statements and losses flow
 * in; immutable snapshots, changes and history flow out. It knows no word of a domain, no agents
 * and no bus.
 */
@NullMarked
package org.maestro.knowledge;

import org.jspecify.annotations.NullMarked;
