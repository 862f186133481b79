package org.maestro.ontology.home;

import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Stream;
import org.apache.jena.graph.Node;
import org.apache.jena.graph.NodeFactory;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.Nearest;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.WordHints;

/**
 * Checks that permissions speak of devices, features, parts and private words that there are: a
 * typing error opens no door.
 */
final class PermissionCheck {
  private final SourceGraph graph;
  private final Home home;
  private final WordHints hints;
  private final Set<String> asked = new TreeSet<>();
  private final Set<String> permitted = new TreeSet<>();
  private final Set<String> forbidden = new TreeSet<>();
  private final Set<String> readable = new TreeSet<>();
  private final Set<String> askedForParts = new TreeSet<>();
  private final Set<String> parts = new TreeSet<>();
  private final PersonalPermissionCheck persons;

  PermissionCheck(SourceGraph graph, Home home) {
    this.graph = graph;
    this.home = home;
    this.hints = new WordHints(graph, home.vocabulary());
    asked.addAll(home.devices().keySet());
    home.vocabulary().classes().keySet().stream()
        .filter(name -> home.vocabulary().isA(name, "Device"))
        .forEach(asked::add);
    permitted.addAll(home.vocabulary().features().keySet());
    home.devices().values().stream()
        .flatMap(device -> device.features().stream())
        .map(FeatureType::name)
        .forEach(permitted::add);
    forbidden.addAll(permitted);
    forbidden.add(PersonalPermission.ANY_FEATURE);
    this.persons = new PersonalPermissionCheck(graph, home);
    readable.addAll(PrivateWords.of(home).all());
    askedForParts.addAll(asked);
    askedForParts.addAll(home.groups().keySet());
    Stream.of(Part.values()).map(Part::word).forEach(parts::add);
  }

  void check(Map<String, Node> nodes) {
    home.individuals().values().stream()
        .filter(thing -> thing.classes().contains("Permission"))
        .forEach(
            thing -> {
              Node node = HomeCheck.named(nodes, thing.name());
              if (graph.objects(node, Maestro.term("opens")).isEmpty()) {
                check(
                    node, "asks", asked, "is neither a device of this home nor a class of devices");
              } else {
                check(
                    node,
                    "asks",
                    askedForParts,
                    "is neither an agent of a group or device of this home nor a class of devices");
              }
              check(node, "opens", parts, "is no part of an agent");
              check(node, "permits", permitted, "is no feature that is known here");
              check(node, "forbids", forbidden, "is no feature that is known here");
              check(node, "reads", readable, "is no private word of this home");
              persons.check(node, thing);
            });
  }

  private void check(Node node, String property, Set<String> known, String problem) {
    for (Node value : graph.objects(node, Maestro.term(property))) {
      if (!known.contains(Literals.name(value))) {
        graph.fault(
            node,
            Maestro.term(property),
            Optional.of(value),
            problem,
            Nearest.cure(Literals.name(value), known, this::written, "name another one"));
      }
    }
  }

  private String written(String name) {
    return Optional.ofNullable(home.devices().get(name))
        .map(device -> graph.written(NodeFactory.createURI(device.individual().iri())))
        .orElseGet(() -> hints.written(name));
  }
}
