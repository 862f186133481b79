package org.maestro.ontology.home;

import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Fault;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;

/** Reads the home of a graph: its things and its devices. */
final class HomeReader {

  private static final String HOME = "Home";
  private static final String ROOM = "Room";
  private static final String ZONE = "Zone";

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final String source;

  HomeReader(SourceGraph graph, Vocabulary vocabulary, String source) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.source = source;
  }

  Home read() {
    Map<String, Individual> individuals = new TreeMap<>();
    Map<String, Node> nodes = new TreeMap<>();
    IndividualReader reader = new IndividualReader(graph, vocabulary);
    Set<Node> homes = Set.copyOf(graph.subjects(RDF.type.asNode(), Maestro.term(HOME)));
    for (Node subject : graph.subjectsOf(source)) {
      if (subject.isURI() && !homes.contains(subject) && !isDeclared(subject)) {
        Individual individual = reader.read(subject);
        checkName(subject, individual.name(), nodes);
        individuals.put(individual.name(), individual);
      }
    }
    roomsAsZones(individuals);
    DeviceReader devices = new DeviceReader(graph, vocabulary);
    Map<String, Device> byId = new TreeMap<>();
    nodes.forEach(
        (name, node) -> {
          Individual individual = individuals.get(name);
          if (individual.classes().contains("Device")) {
            byId.put(name, devices.read(node, individual));
          }
        });
    Node home = homeNode(homes);
    return new Home(
        home.isURI() ? home.getURI() : "",
        new Literals(graph).label(home),
        vocabulary,
        individuals,
        byId);
  }

  private Node homeNode(Set<Node> homes) {
    if (homes.size() == 1) {
      return homes.iterator().next();
    }
    Fault fault =
        new Fault(
            source,
            1,
            "the file",
            "",
            "describes " + (homes.isEmpty() ? "no home" : homes.size() + " homes"),
            "write one statement such as <https://w3id.org/maestro/home/mine> a maestro:Home");
    graph.fault(fault);
    return Maestro.term("");
  }

  /** Whether the file declares a word with it, rather than describe a thing. */
  private boolean isDeclared(Node subject) {
    String name = Literals.name(subject);
    return isIri(
            vocabulary.classes().get(name) == null ? "" : vocabulary.classes().get(name).iri(),
            subject)
        || isIri(vocabulary.predicate(name).map(declared -> declared.iri()).orElse(""), subject)
        || isIri(
            vocabulary.features().containsKey(name) ? vocabulary.features().get(name).iri() : "",
            subject);
  }

  private static boolean isIri(String iri, Node node) {
    return iri.equals(node.getURI());
  }

  private void checkName(Node subject, String name, Map<String, Node> nodes) {
    Node other = nodes.putIfAbsent(name, subject);
    if (other != null) {
      graph.fault(subject, "has the local name of " + other.getURI(), "give it another name");
    }
    if (vocabulary.classes().containsKey(name)
        || vocabulary.predicates().containsKey(name)
        || vocabulary.features().containsKey(name)) {
      graph.fault(subject, "has the name of a word of the vocabulary", "give it another name");
    }
  }

  /** Without any zone, each room is one. */
  private static void roomsAsZones(Map<String, Individual> individuals) {
    if (individuals.values().stream().anyMatch(thing -> thing.classes().contains(ZONE))) {
      return;
    }
    individuals.replaceAll(
        (name, thing) -> {
          if (!thing.classes().contains(ROOM)) {
            return thing;
          }
          Set<String> classes = new TreeSet<>(thing.classes());
          classes.addAll(List.of(ZONE, "Place"));
          return new Individual(name, thing.iri(), thing.label(), classes, thing.properties());
        });
  }
}
