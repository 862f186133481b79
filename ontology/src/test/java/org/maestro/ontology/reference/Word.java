package org.maestro.ontology.reference;

import java.util.List;
import org.apache.jena.rdf.model.Resource;

/**
 * A class, property or feature of the ontology.
 *
 * @param name with its prefix, such as {@code maestro:outline}
 * @param traits what else is to be known of it, one line each
 */
record Word(Resource node, String name, String label, String comment, List<String> traits) {}
