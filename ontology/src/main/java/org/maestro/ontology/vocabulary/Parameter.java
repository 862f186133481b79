package org.maestro.ontology.vocabulary;

import java.util.List;
import org.maestro.sl.Term;

/**
 * An input, a binding made by the planner, or an output of a feature.
 *
 * @param types class names, or datatypes by local name ({@code decimal}, {@code boolean}, {@code
 *     Pose}); any one of them fits
 * @param oneOf the values to choose from, or empty for all individuals of the types
 * @param needs local names of the properties that travel with a pointer into the knowledge base
 */
public record Parameter(
    String name, List<String> types, List<Term> oneOf, List<String> needs, boolean optional) {
  public Parameter {
    types = List.copyOf(types);
    oneOf = List.copyOf(oneOf);
    needs = List.copyOf(needs);
  }
}
