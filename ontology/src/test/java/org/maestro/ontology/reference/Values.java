package org.maestro.ontology.reference;

import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.apache.jena.rdf.model.Property;
import org.apache.jena.rdf.model.Resource;
import org.apache.jena.vocabulary.RDF;
import org.apache.jena.vocabulary.RDFS;

/** Which values a property has, in words. */
final class Values {
  private static final Property ARGUMENTS = Ontology.term("arguments");
  private static final Property UNIT = Ontology.term("unit");
  private static final Map<String, String> UNITS =
      Map.ofEntries(
          Map.entry("LUX", "lux"),
          Map.entry("M", "m"),
          Map.entry("M2", "m²"),
          Map.entry("KiloGM", "kg"),
          Map.entry("M-PER-SEC", "m/s"),
          Map.entry("W", "W"),
          Map.entry("DEG", "degrees"),
          Map.entry("DEG_C", "°C"),
          Map.entry("HZ", "Hz"),
          Map.entry("K", "K"),
          Map.entry("CD", "cd"),
          Map.entry("MIN", "minutes"),
          Map.entry("SEC", "seconds"));

  private final Shapes shapes;
  private final Function<Resource, String> names;

  Values(Shapes shapes, Function<Resource, String> names) {
    this.shapes = shapes;
    this.names = names;
  }

  String of(Resource word) {
    String unit = unit(word);
    List<String> arguments = arguments(word);
    if (word.hasProperty(RDF.type, Ontology.term("Fluent"))) {
      String least = word.hasProperty(Ontology.term("least")) ? ", 0 at least" : "";
      return "a number" + unit + least + in(word);
    }
    if (!arguments.isEmpty()) {
      return (arguments.size() == 1 ? "true or false" : other(arguments.get(1))) + in(word);
    }
    if (word.hasProperty(RDFS.range)) {
      return kind(word.getPropertyResourceValue(RDFS.range)) + unit;
    }
    return shapes.isNumber(word) || !unit.isEmpty() ? "a number" + unit : "as said above";
  }

  private static String in(Resource word) {
    return isStated(word)
        ? ""
        : arguments(word).stream()
            .map(one -> "`" + one + "`")
            .collect(Collectors.joining(" ", "; in formulas only, of ", ""));
  }

  private static String other(String argument) {
    int dash = argument.indexOf(" - ");
    return dash < 0 ? "a text" : "a " + argument.substring(dash + 3);
  }

  private String kind(Resource range) {
    return switch (range.getLocalName()) {
      case "string" -> "a text";
      case "decimal" -> "a number";
      case "integer" -> "a whole number";
      case "boolean" -> "`true` or `false`";
      case "duration" -> "a duration, such as `\"PT10M\"^^xsd:duration`";
      case "List" -> "a list";
      case "Class" -> "a class";
      case "Property" -> "a property";
      default -> "a " + Traits.link(names.apply(range));
    };
  }

  static List<String> arguments(Resource word) {
    return word.hasProperty(ARGUMENTS)
        ? word.getProperty(ARGUMENTS).getList().asJavaList().stream()
            .map(node -> node.asLiteral().getString())
            .toList()
        : List.of();
  }

  private static String unit(Resource word) {
    if (!word.hasProperty(UNIT)) {
      return "";
    }
    String name = word.getPropertyResourceValue(UNIT).getURI().replaceAll(".*/", "");
    return " in " + UNITS.getOrDefault(name, name);
  }

  /** Whether a home can say it: what follows, is computed, or has more arguments is not said. */
  static boolean isStated(Resource property) {
    int most = property.hasProperty(RDF.type, Ontology.term("Fluent")) ? 1 : 2;
    return arguments(property).size() <= most
        && !property.hasProperty(Ontology.term("derivedWhen"))
        && !property.hasProperty(RDF.type, Ontology.term("GeometryFunction"));
  }
}
