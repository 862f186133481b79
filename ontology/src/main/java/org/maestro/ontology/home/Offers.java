package org.maestro.ontology.home;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.FeatureReader;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;

/** Which features there are, and which classes of devices, and devices of a home, offer them. */
final class Offers {
  private static final Node OFFERS = Maestro.term("offers");

  private final Home home;
  private final Map<String, Map<String, FeatureType>> offers = new TreeMap<>();

  Offers(SourceGraph graph, Home home) {
    this.home = home;
    Vocabulary vocabulary = home.vocabulary();
    vocabulary.features().keySet().forEach(name -> offers.put(name, new TreeMap<>()));
    FeatureReader reader = new FeatureReader(graph, vocabulary::isFluent);
    for (Node offerer : graph.subjectsWith(OFFERS)) {
      if (vocabulary.classes().containsKey(Literals.name(offerer))) {
        for (Node offered : graph.objects(offerer, OFFERS)) {
          type(offered, graph, vocabulary)
              .map(type -> offered.isURI() ? type : reader.read(offered, type))
              .ifPresent(type -> add(type, Literals.name(offerer)));
        }
      }
    }
    home.devices()
        .forEach((name, device) -> device.features().forEach(feature -> add(feature, name)));
  }

  /** The features that are known, offered or not. */
  List<String> known() {
    return List.copyOf(offers.keySet());
  }

  /** The feature as each of those classes and devices offers it. */
  List<FeatureType> of(String feature, Predicate<String> offerers) {
    return offers.getOrDefault(feature, Map.of()).entrySet().stream()
        .filter(offer -> offerers.test(offer.getKey()))
        .map(Map.Entry::getValue)
        .toList();
  }

  /** What their features occupy of those who offer them. */
  Set<String> components(Predicate<String> offerers) {
    return offers.values().stream()
        .flatMap(offered -> offered.entrySet().stream())
        .filter(offer -> offerers.test(offer.getKey()))
        .flatMap(offer -> offer.getValue().occupies().stream())
        .collect(Collectors.toCollection(TreeSet::new));
  }

  /** Devices of the home, and classes of devices, that may be of one of these classes. */
  Predicate<String> whoMayBe(List<String> classes) {
    return offerer -> classes.stream().anyMatch(className -> mayBe(offerer, className));
  }

  private boolean mayBe(String offerer, String className) {
    Vocabulary vocabulary = home.vocabulary();
    Device device = home.devices().get(offerer);
    return !vocabulary.classes().containsKey(className)
        || (device != null
            ? device.individual().classes().contains(className)
            : vocabulary.mayBeBoth(offerer, className));
  }

  private void add(FeatureType type, String offerer) {
    offers.computeIfAbsent(type.name(), name -> new TreeMap<>()).put(offerer, type);
  }

  private static Optional<FeatureType> type(
      Node offered, SourceGraph graph, Vocabulary vocabulary) {
    return Stream.concat(Stream.of(offered), graph.objects(offered, RDF.type.asNode()).stream())
        .flatMap(
            node -> Optional.ofNullable(vocabulary.features().get(Literals.name(node))).stream())
        .findFirst();
  }
}
