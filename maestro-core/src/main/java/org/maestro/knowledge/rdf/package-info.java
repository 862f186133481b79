/**
 * The dataset with provenance: in memory, on disk, or behind a SPARQL endpoint, slow ones written
 * beside those who write. Edits and queries flow in; rows flow out. Jena is known here and nowhere
 * above.
 */
@NullMarked
package org.maestro.knowledge.rdf;

import org.jspecify.annotations.NullMarked;
