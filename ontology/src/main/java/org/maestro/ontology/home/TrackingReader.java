package org.maestro.ontology.home;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import org.apache.jena.graph.Node;
import org.apache.jena.vocabulary.RDF;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.ontology.vocabulary.Literals;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.ontology.vocabulary.VocabularyCheck;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/**
 * Reads how the persons of a home are followed, from the agent of the home and from its classes;
 * what is lacking or makes no sense becomes a fault of the graph.
 */
final class TrackingReader {
  private static final String TRACKER = "PersonTracker";
  private static final List<String> BOTH = List.of(PersonCue.PERSON, PersonCue.ZONE);

  private final SourceGraph graph;
  private final Vocabulary vocabulary;
  private final VocabularyCheck check;
  private final Literals literals;
  private final CueReader cues;

  TrackingReader(SourceGraph graph, Vocabulary vocabulary, VocabularyCheck check) {
    this.graph = graph;
    this.vocabulary = vocabulary;
    this.check = check;
    this.literals = new Literals(graph);
    this.cues = new CueReader(graph, check);
  }

  /**
   * The agent that does it; empty when the home has none, or it cannot be read.
   *
   * @param nodes of the home's things, by their names
   */
  Optional<PersonTracking> read(Map<String, Individual> individuals, Map<String, Node> nodes) {
    List<Individual> trackers =
        individuals.values().stream()
            .filter(individual -> individual.classes().contains(TRACKER))
            .toList();
    if (trackers.isEmpty()) {
      return Optional.empty();
    }
    Node node = HomeCheck.named(nodes, trackers.get(0).name());
    if (trackers.size() > 1) {
      graph.fault(
          HomeCheck.named(nodes, trackers.get(1).name()),
          "is a second person tracker, and one follows the persons of all rooms",
          "keep one of both");
    }
    return read(node);
  }

  private Optional<PersonTracking> read(Node node) {
    List<Node> layers = layers(node);
    Optional<Formula.Atom> tells = atom(layers, "tells", BOTH);
    Optional<Formula> ways =
        first(
            layers,
            layer ->
                literals.parsed(
                    layer, "ways", text -> SlParser.formula(text, vocabulary::isFluent)));
    layers.forEach(
        layer ->
            literals
                .parsed(layer, "ways", text -> SlParser.formula(text, vocabulary::isFluent))
                .ifPresent(
                    formula -> check.checkFormula(layer, "ways", List.of("a", "b"), formula)));
    Optional<String> tracked = first(layers, layer -> literals.text(layer, "tracks"));
    Optional<PersonTracking.Habits> habits = habits(node, layers);
    if (tells.isEmpty() || ways.isEmpty() || tracked.isEmpty() || habits.isEmpty()) {
      if (graph.faults().isEmpty()) {
        graph.fault(
            node,
            "does not say whom it tracks, by which ways they go, how long they stay, or what it"
                + " tells",
            "give it the class FamilyTracker, or all of maestro:tracks, tells, ways, staysFor,"
                + " staysAway and passesWithin");
      }
      return Optional.empty();
    }
    return Optional.of(
        new PersonTracking(
            Literals.name(node),
            tracked.get(),
            new PersonTracking.Words(
                tells.get(),
                atom(layers, "supposes", BOTH),
                atom(layers, "foretells", BOTH),
                atom(layers, "noticesGuest", List.of(PersonCue.ZONE))),
            ways.get(),
            waysOut(layers),
            habits.get(),
            share(node, layers, "sureFrom", 0.5).orElse(0.9),
            share(node, layers, "foretellsFrom", 0.5).orElse(0.7),
            cues.read()));
  }

  /** The tracker, then its classes, the most special one first. */
  private List<Node> layers(Node node) {
    List<Node> classes = new ArrayList<>(graph.objects(node, RDF.type.asNode()));
    classes.sort(
        Comparator.comparingInt(this::ancestors)
            .reversed()
            .thenComparing(type -> Literals.name(type)));
    classes.add(0, node);
    return classes;
  }

  private int ancestors(Node type) {
    return Optional.ofNullable(vocabulary.classes().get(Literals.name(type)))
        .map(declared -> declared.ancestors().size())
        .orElse(0);
  }

  private static <T> Optional<T> first(List<Node> layers, Function<Node, Optional<T>> value) {
    return layers.stream().map(value).flatMap(Optional::stream).findFirst();
  }

  private Optional<Formula.Atom> atom(List<Node> layers, String property, List<String> variables) {
    return first(
        layers,
        layer -> {
          Optional<Fact> fact = literals.parsed(layer, property, SlParser::fact);
          if (fact.isPresent() && !(fact.get() instanceof Fact.Holds)) {
            fault(layer, property, "is no plain fact", "write one such as \"(in ?person ?zone)\"");
          }
          return fact.filter(Fact.Holds.class::isInstance)
              .map(holds -> ((Fact.Holds) holds).atom())
              .filter(
                  atom -> {
                    check.checkFormula(layer, property, variables, atom);
                    return true;
                  });
        });
  }

  private Optional<PersonTracking.Habits> habits(Node node, List<Node> layers) {
    Optional<Duration> stay = duration(layers, "staysFor");
    Optional<Duration> absence = duration(layers, "staysAway");
    Optional<Duration> passage = duration(layers, "passesWithin");
    OptionalDouble guests = share(node, layers, "guestShare", 0);
    return stay.isEmpty() || absence.isEmpty() || passage.isEmpty()
        ? Optional.empty()
        : Optional.of(
            new PersonTracking.Habits(stay.get(), absence.get(), passage.get(), guests.orElse(0)));
  }

  private Optional<Duration> duration(List<Node> layers, String property) {
    return first(
        layers,
        layer -> {
          Optional<Duration> time = literals.duration(layer, property);
          if (time.filter(one -> one.isNegative() || one.isZero()).isPresent()) {
            fault(layer, property, "leaves no time", "write days to seconds, such as PT3M");
          }
          return time.filter(one -> !one.isNegative() && !one.isZero());
        });
  }

  private OptionalDouble share(Node node, List<Node> layers, String property, double least) {
    Optional<Double> share =
        first(
            layers,
            layer -> {
              OptionalDouble number = literals.number(layer, property);
              return number.isPresent() ? Optional.of(number.getAsDouble()) : Optional.empty();
            });
    if (share.filter(number -> number >= least && number <= 1).isPresent()) {
      return OptionalDouble.of(share.get());
    }
    share.ifPresent(
        number ->
            fault(
                node,
                property,
                "is no probability from %s to 1"
                    .formatted(least == 0 ? "0" : String.valueOf(least)),
                "write one, such as 0.9"));
    return OptionalDouble.empty();
  }

  private Set<String> waysOut(List<Node> layers) {
    Set<String> zones = new TreeSet<>();
    Node property = Maestro.term("wayOut");
    for (Node zone : layers.stream().flatMap(l -> graph.objects(l, property).stream()).toList()) {
      if (!graph.isA(zone, Maestro.term("Zone"))) {
        graph.fault(
            layers.get(0), property, Optional.of(zone), "is no zone", "name a zone of the home");
      }
      zones.add(Literals.name(zone));
    }
    return zones;
  }

  private void fault(Node node, String property, String problem, String cure) {
    Node term = Maestro.term(property);
    graph.fault(node, term, graph.object(node, term), problem, cure);
  }
}
