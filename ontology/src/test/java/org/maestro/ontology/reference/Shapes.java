package org.maestro.ontology.reference;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.apache.jena.rdf.model.Model;
import org.apache.jena.rdf.model.Property;
import org.apache.jena.rdf.model.RDFNode;
import org.apache.jena.rdf.model.Resource;
import org.apache.jena.shacl.vocabulary.SHACLM;

/** What the shapes ask of a property: of which classes, how often, and what {@code check} says. */
final class Shapes {
  private final Model model;
  private final Function<Resource, String> names;

  Shapes(Model model, Function<Resource, String> names) {
    this.model = model;
    this.names = names;
  }

  /** For each class that has to state the property, or usually does, which of both. */
  Map<String, String> demands(Resource property) {
    Map<String, String> demands = new LinkedHashMap<>();
    for (Resource asked : asked(property)) {
      if (asked.hasProperty(SHACLM.minCount)) {
        String degree = asked.hasProperty(SHACLM.severity, SHACLM.Warning) ? "usual" : "required";
        targets(asked).forEach(target -> demands.put(names.apply(target), degree));
      }
    }
    return demands;
  }

  /** The classes of which the shapes speak with the property. */
  List<String> classes(Resource property) {
    return asked(property).stream()
        .flatMap(asked -> targets(asked).stream())
        .map(names)
        .distinct()
        .sorted()
        .toList();
  }

  /** Each sentence that is said of a value that is not right. */
  List<String> complaints(Resource property) {
    return asked(property).stream()
        .map(asked -> asked.getProperty(SHACLM.message).getString())
        .filter(
            message -> !message.startsWith("is missing") && !message.startsWith("is stated more"))
        .distinct()
        .sorted()
        .toList();
  }

  /** Whether the values are numbers by what the shapes ask of them. */
  boolean isNumber(Resource property) {
    return List.of(SHACLM.minInclusive, SHACLM.minExclusive, SHACLM.maxInclusive).stream()
        .anyMatch(limit -> asked(property).stream().anyMatch(asked -> asked.hasProperty(limit)));
  }

  private List<Resource> asked(Resource property) {
    return model.listSubjectsWithProperty(SHACLM.path, property).toList();
  }

  private List<Resource> targets(Resource asked) {
    List<Resource> targets = new ArrayList<>();
    for (Resource shape : model.listSubjectsWithProperty(SHACLM.property, asked).toList()) {
      targets(shape, SHACLM.targetClass, targets);
    }
    return targets;
  }

  private static void targets(Resource shape, Property property, List<Resource> targets) {
    shape
        .listProperties(property)
        .mapWith(said -> said.getObject())
        .forEach(node -> add(node, targets));
  }

  private static void add(RDFNode node, List<Resource> targets) {
    targets.add(node.asResource());
  }
}
