/**
 * The reference of all words for homes, {@code docs/reference-homes.md}, as the ontology has it.
 */
package org.maestro.ontology.reference;
