package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.KnowledgeSettings;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.Store;
import org.maestro.knowledge.belief.Measures;
import org.maestro.knowledge.rdf.GraphStorageFactory;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.ontology.vocabulary.Reliability;
import org.maestro.ontology.vocabulary.Timing;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * Two rooms of 3 m, side by side along x, with a person, a cup, a camera and a lamp for each, and a
 * robot.
 */
public final class Household {

  public static final Source CAMERA = new Source(Source.Kind.OBSERVED, "cam-b");
  static final Source ROBOT = new Source(Source.Kind.STATED, "rose");

  public final SteppedClock clock = new SteppedClock();
  public final CollectiveKnowledge knowledge;

  public Household() {
    this(KnowledgeSettings.inMemory());
  }

  public Household(Store store) {
    this(KnowledgeSettings.inMemory().with(store));
  }

  public Household(KnowledgeSettings settings) {
    knowledge =
        new CollectiveKnowledge(
            home(),
            clock,
            home -> new Plane(),
            GraphStorageFactory.open(settings.store()),
            settings);
    knowledge.restore();
  }

  /** What is believed is what stands in the dataset, wherever that is. */
  public void close() {
    assertThat(
            knowledge.select(
                "SELECT ?f WHERE { GRAPH <https://example.org/home#graph/world>"
                    + " { ?o <https://w3id.org/maestro#fact> ?f } }"))
        .extracting(row -> row.get("f"))
        .containsExactlyInAnyOrderElementsOf(
            knowledge.snapshot().beliefs().stream()
                .filter(belief -> belief.source().kind() != Source.Kind.DESCRIBED)
                .map(Belief::fact)
                .toList());
    knowledge.close();
  }

  static Home home() {
    Map<String, PredicateDeclaration> predicates = new TreeMap<>();
    Stream.of(
            observed("in", "functional", "?x - Thing", "?p - Place", "(inside ?x ?p)", 600),
            observed(
                "nextTo",
                "symmetric",
                "?a - Thing",
                "?b - Thing",
                "(<= (distance ?a ?b) 0.6)",
                600),
            observed("canSee", "", "?a - Device", "?x - Thing", "", 2),
            declared("illuminance", "fluent observable positive", 300, "", "?z - Zone"),
            declared("level", "fluent observable", 0, "", "?d - Device"),
            declared("covers", "", 0, "", "?d - Device", "?z - Zone"),
            declared("open", "", 0, "", "?d - Device"),
            declared("handFree", "", 0, "(not (exists (?x - Item) (in ?x ?r)))", "?r - Device"))
        .forEach(p -> predicates.put(p.name(), p));
    Map<String, Individual> individuals = new TreeMap<>();
    Map<String, Device> devices = new TreeMap<>();
    Stream.of(
            individual("zone-a", "Zone Place"),
            individual("zone-b", "Zone Place"),
            individual("Bob", "Thing Person"),
            individual("Cup", "Thing Item"),
            individual("cam-a", "Device", "covers", "zone-a"),
            individual("cam-b", "Device", "covers", "zone-b"),
            individual("lamp-b1", "Device"),
            individual("rose", "Device Thing Place"))
        .forEach(
            individual -> {
              individuals.put(individual.name(), individual);
              if (individual.classes().contains("Device")) {
                devices.put(individual.name(), device(individual));
              }
            });
    return new Home(
        "https://example.org/home#",
        "home",
        new Vocabulary(Map.of(), predicates, Map.of()),
        individuals,
        devices);
  }

  static Device device(Individual individual) {
    return new Device(individual, Optional.empty(), Optional.empty(), List.of(), Map.of());
  }

  static Individual individual(String name, String classes, String... propertyAndValue) {
    return new Individual(
        name,
        "https://example.org/home#" + name,
        name,
        Set.of(classes.split(" ")),
        propertyAndValue.length == 0
            ? Map.of()
            : Map.of(propertyAndValue[0], List.of(new Term.Name(propertyAndValue[1]))));
  }

  public static FeatureType feature(String effect, String learns) {
    return new FeatureType(
        "feature",
        "https://example.org/feature",
        false,
        "",
        List.of(),
        List.of(),
        List.of(),
        new Formula.And(List.of()),
        effect.isEmpty() ? new Effect.All(List.of()) : SlParser.effect(effect, Household::isFluent),
        learns.isEmpty() ? Optional.empty() : Optional.of(SlParser.effect(learns)),
        false,
        Optional.empty(),
        OptionalDouble.empty(),
        Set.of(),
        List.of(),
        List.of(),
        new Price.Stated(SlParser.expression("1")),
        SlParser.expression("1"),
        Timing.USUAL,
        Reliability.USUAL,
        Optional.empty(),
        "feature",
        Map.of());
  }

  public void state(Source source, String... facts) {
    knowledge.state(source, List.of(facts));
  }

  public Truth truth(String formula) {
    return new Question(knowledge.snapshot()).queryIf(SlParser.formula(formula));
  }

  public OptionalDouble number(String fluent) {
    return knowledge.snapshot().number((Expression.Fluent) SlParser.expression(fluent));
  }

  Optional<Belief> belief(String atom) {
    return knowledge.snapshot().belief((Formula.Atom) SlParser.formula(atom));
  }

  public void pass(Duration time) {
    Duration until = clock.now().plus(time);
    clock.schedule(time, "test", () -> {});
    clock.runUntil(() -> clock.now().compareTo(until) >= 0, time.multipliedBy(2));
  }

  private static boolean isFluent(String name) {
    return Set.of("illuminance", "level").contains(name);
  }

  private static PredicateDeclaration observed(
      String name, String traits, String first, String second, String when, int seconds) {
    return declaration(
        name,
        "observable " + traits,
        seconds,
        "",
        when,
        SlParser.variable(first),
        SlParser.variable(second));
  }

  private static PredicateDeclaration declared(
      String name, String traits, int seconds, String derivedWhen, String... parameters) {
    return declaration(
        name,
        traits,
        seconds,
        derivedWhen,
        "",
        Stream.of(parameters).map(SlParser::variable).toArray(TypedVariable[]::new));
  }

  private static PredicateDeclaration declaration(
      String name,
      String traits,
      int seconds,
      String derivedWhen,
      String observedWhen,
      TypedVariable... parameters) {
    List<String> traitList = List.of(traits.split(" "));
    return new PredicateDeclaration(
        name,
        "https://example.org/words#" + name,
        name,
        List.of(parameters),
        traitList.contains("fluent"),
        traitList.contains("observable"),
        traitList.contains("functional"),
        traitList.contains("symmetric"),
        seconds == 0 ? Optional.empty() : Optional.of(Duration.ofSeconds(seconds)),
        name.equals("in") ? Map.of("Person", Duration.ofSeconds(30)) : Map.of(),
        Optional.of(derivedWhen).filter(text -> !text.isEmpty()).map(SlParser::formula),
        Optional.of(observedWhen).filter(text -> !text.isEmpty()).map(SlParser::formula),
        Optional.empty(),
        Optional.empty(),
        Optional.empty(),
        traitList.contains("positive") ? OptionalDouble.of(0) : OptionalDouble.empty(),
        Optional.empty());
  }

  /** Positions along x alone: zone a up to 3 m, zone b beyond. */
  private static final class Plane implements Measures {

    @Override
    public boolean isNumber(String function) {
      return function.equals("distance");
    }

    @Override
    public boolean isTruth(String function) {
      return function.equals("inside");
    }

    @Override
    public OptionalDouble number(String function, List<Term> arguments, Snapshot snapshot) {
      OptionalDouble a = x(arguments.get(0), snapshot);
      OptionalDouble b = x(arguments.get(1), snapshot);
      return a.isPresent() && b.isPresent()
          ? OptionalDouble.of(Math.abs(a.getAsDouble() - b.getAsDouble()))
          : OptionalDouble.empty();
    }

    @Override
    public Truth truth(String function, List<Term> arguments, Snapshot snapshot) {
      OptionalDouble x = x(arguments.get(0), snapshot);
      String place = ((Term.Name) arguments.get(1)).text();
      return x.isEmpty() || !place.startsWith("zone")
          ? Truth.UNKNOWN
          : Truth.of(place.equals(x.getAsDouble() <= 3 ? "zone-a" : "zone-b"));
    }

    private static OptionalDouble x(Term thing, Snapshot snapshot) {
      return snapshot
          .value("position", List.of(thing))
          .map(p -> OptionalDouble.of(Double.parseDouble(((Term.Text) p).value().split(" ")[0])))
          .orElse(OptionalDouble.empty());
    }
  }
}
