package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.FeatureReader;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.vocabulary.VocabularyCheck;
import org.maestro.ontology.vocabulary.WordHints;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;

/** Reads a device with what its classes, from the general to the special, and it itself say. */
final class DeviceReader {

  private static final Node OFFERS = Maestro.term("offers");

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final Literals literals;
  private final FeatureReader features;
  private final SettingReader settingReader;

  private final VocabularyCheck check;
  private final WordHints hints;

  DeviceReader(SourceGraph graph, Vocabulary vocabulary, VocabularyCheck check) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.check = check;
    this.hints = new WordHints(graph, vocabulary);
    this.literals = new Literals(graph);
    this.features = new FeatureReader(graph, vocabulary::isFluent);
    this.settingReader = new SettingReader(graph);
  }

  Device read(Node node, Individual individual) {
    List<Node> layers = layers(node);
    Optional<String> container = Optional.empty();
    Optional<String> driver = Optional.empty();
    Map<String, String> reports = new TreeMap<>();
    Map<String, Setting> settings = new TreeMap<>();
    Map<String, Offer> offers = new LinkedHashMap<>();
    Set<Formula> pursues = new LinkedHashSet<>();
    StatedWorth worth = StatedWorth.NONE;
    Aims aims = new Aims(graph, vocabulary, check, name -> false);
    for (Node layer : layers) {
      container = literals.text(layer, "container").or(orElse(container));
      driver = literals.text(layer, "driver").or(orElse(driver));
      reports = features.namedFacts(layer, "reports", reports);
      check.checkFacts(layer, "reports", List.of(Self.NAME));
      settings = settingReader.read(layer, settings);
      pursues.addAll(aims.pursued(layer));
      worth = aims.worth(layer).or(worth);
      Set<String> special = new LinkedHashSet<>();
      for (Node offered : graph.objects(layer, OFFERS)) {
        typeOf(offered)
            .map(Literals::name)
            .filter(name -> offered.isBlank() && !special.add(name))
            .ifPresent(
                name ->
                    graph.fault(
                        layer,
                        OFFERS,
                        Optional.empty(),
                        "names " + name + " twice, each time otherwise",
                        "keep one of both"));
        offer(layer, individual, offered, offers);
      }
    }
    Map<String, Setting> set = settings;
    List<FeatureType> types =
        offers.values().stream()
            .sorted(
                Comparator.comparingDouble(Offer::order).thenComparing(offer -> offer.type.name()))
            .map(offer -> SettingReader.choosing(offer.type, set))
            .toList();
    if (pursues.isEmpty() && !worth.equals(StatedWorth.NONE)) {
      graph.fault(
          node,
          "says what its goals are worth, and has none",
          "state one by maestro:pursues, or leave maestro:benefit, maestro:chance and"
              + " maestro:allowed out");
    }
    return new Device(
        individual,
        container,
        driver,
        types,
        reports,
        settings,
        List.copyOf(pursues),
        worth,
        Extension.NONE);
  }

  private static <T> Supplier<Optional<T>> orElse(Optional<T> before) {
    return () -> before;
  }

  /** The device's classes, the one with the fewest ancestors first, and the device. */
  private List<Node> layers(Node node) {
    List<Node> layers = new ArrayList<>(graph.objects(node, RDF.type.asNode()));
    layers.sort(
        Comparator.comparingInt(this::ancestors).thenComparing(type -> Literals.name(type)));
    layers.add(node);
    return layers;
  }

  private int ancestors(Node type) {
    return Optional.ofNullable(vocabulary.classes().get(Literals.name(type)))
        .map(declared -> declared.ancestors().size())
        .orElse(0);
  }

  private void offer(Node device, Individual individual, Node offered, Map<String, Offer> offers) {
    Optional<Node> typeNode = typeOf(offered);
    String name = typeNode.map(Literals::name).orElse("");
    FeatureType known = vocabulary.features().get(name);
    if (typeNode.isEmpty() || known == null && !FeatureReader.isFeature(graph, typeNode.get())) {
      graph.fault(
          device,
          OFFERS,
          Optional.of(typeNode.orElse(offered)),
          "is no known feature",
          hints.cure(
              typeNode.map(Literals::name).orElse(""),
              vocabulary.features().keySet(),
              vocabulary.features().isEmpty()
                  ? "describe it as a maestro:Action or maestro:Task"
                  : "offer one of "
                      + vocabulary.features().keySet().stream()
                          .map(hints::written)
                          .collect(Collectors.joining(", "))
                      + ", or describe it as a maestro:Action or maestro:Task"));
      return;
    }
    if (name.startsWith("$")) {
      graph.fault(
          typeNode.get(),
          "has a name that is kept for the bus itself",
          "begin the name of the feature with a letter");
    }
    Offer before = offers.get(name);
    FeatureType base =
        before != null ? before.type : known != null ? known : features.read(typeNode.get());
    FeatureType type = offered.equals(typeNode.get()) ? base : features.read(offered, base);
    if (offered.isURI() && known != null) {
      check.check(offered, type);
    } else {
      check.check(offered, type, individual.classes());
    }
    double order =
        literals
            .number(offered, "order")
            .orElse(literals.number(typeNode.get(), "order").orElse(Double.MAX_VALUE));
    offers.put(name, new Offer(type, order));
  }

  /** The feature type itself, or the type of a node that says what differs. */
  private Optional<Node> typeOf(Node offered) {
    if (offered.isURI()) {
      return Optional.of(offered);
    }
    return graph.objects(offered, RDF.type.asNode()).stream()
        .filter(Node::isURI)
        .filter(
            type ->
                vocabulary.features().containsKey(Literals.name(type))
                    || FeatureReader.isFeature(graph, type))
        .findFirst()
        .or(() -> graph.object(offered, RDF.type.asNode()));
  }

  private record Offer(FeatureType type, double order) {}
}
