/**
 * Reading RDF texts so that every fault in them can be told with file, line, subject, property,
 * what is wrong and what would be right. Turtle and JSON-LD flow in, a graph with origins, inferred
 * statements and faults flows out to the readers of vocabularies and homes. It knows the
 * meta-vocabulary, no domain, and never reaches for the network.
 */
@NullMarked
package org.maestro.ontology.validation;

import org.jspecify.annotations.NullMarked;
