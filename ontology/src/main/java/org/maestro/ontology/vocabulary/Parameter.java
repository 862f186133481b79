package org.maestro.ontology.vocabulary;

import java.util.List;
import java.util.Set;
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
  /** The share, 0 to 1, of a place's floor of which a result speaks. */
  public static final String COVERED_SHARE = "CoveredShare";

  /** Where the member's plan takes it next; told by the controller, never chosen by the planner. */
  public static final String NEXT_PLACE = "NextPlace";

  /** Datatypes of the meta-vocabulary; all others are XML Schema's. */
  public static final List<String> OWN_DATATYPES = List.of("Pose", COVERED_SHARE, NEXT_PLACE);

  private static final Set<String> XML_NUMBERS =
      Set.of(
          "decimal",
          "double",
          "float",
          "integer",
          "int",
          "long",
          "short",
          "byte",
          "nonNegativeInteger",
          "positiveInteger");

  private static final Set<String> OTHER_XML_DATATYPES =
      Set.of("boolean", "string", "duration", "dateTime", "date", "time", "anyURI");

  public Parameter {
    types = List.copyOf(types);
    oneOf = List.copyOf(oneOf);
    needs = List.copyOf(needs);
  }

  /** Whether a plan can choose a value: one that is named, a truth, or a thing of a class. */
  public boolean hasChoice() {
    return !oneOf.isEmpty()
        || types.stream().anyMatch(type -> type.equals("boolean") || !isDatatype(type));
  }

  /** Whether it stands for things, all of them. */
  boolean isOfThings() {
    return !types.isEmpty() && types.stream().noneMatch(Parameter::isDatatype);
  }

  /** Whether a type of this name is one of numbers. */
  public static boolean isNumber(String type) {
    return XML_NUMBERS.contains(type);
  }

  /** Whether a type of this name is one of values, not of things. */
  public static boolean isDatatype(String type) {
    return OWN_DATATYPES.contains(type)
        || XML_NUMBERS.contains(type)
        || OTHER_XML_DATATYPES.contains(type);
  }
}
