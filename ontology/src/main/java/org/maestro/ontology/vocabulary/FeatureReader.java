package org.maestro.ontology.vocabulary;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.DoublePredicate;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.apache.jena.graph.Node;
import org.maestro.ontology.validation.Maestro;
import org.maestro.ontology.validation.SourceGraph;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * Reads feature types, whole or as what differs from a type. Parameters are told apart by name and
 * come sorted by it.
 */
public final class FeatureReader {

  private static final Node COST = Maestro.term("cost");

  /** The longest time that a call may have on the bus, in seconds. */
  private static final double LONGEST = 7 * 24 * 3600;

  private final SourceGraph graph;
  private final Literals literals;
  private final Predicate<String> fluents;

  /**
   * @param fluents which names are numeric fluents
   */
  public FeatureReader(SourceGraph graph, Predicate<String> fluents) {
    this.graph = graph;
    this.literals = new Literals(graph);
    this.fluents = fluents;
  }

  /** Whether the graph itself describes the node as an action or a task. */
  public static boolean isFeature(SourceGraph graph, Node node) {
    return graph.isA(node, Maestro.term("Action")) || graph.isA(node, Maestro.term("Task"));
  }

  /** A feature type that the node describes whole. */
  public FeatureType read(Node node) {
    FeatureType blank =
        new FeatureType(
            Literals.name(node),
            node.isURI() ? node.getURI() : "",
            graph.isA(node, Maestro.term("Task")),
            spoken(node),
            List.of(),
            List.of(),
            List.of(),
            new Formula.And(List.of()),
            new Effect.All(List.of()),
            Optional.empty(),
            false,
            Optional.empty(),
            OptionalDouble.empty(),
            Set.of(),
            List.of(),
            List.of(),
            new Price.Stated(new Expression.OfTerm(new Term.Number(0))),
            new Expression.OfTerm(new Term.Number(0)),
            Timing.USUAL,
            Reliability.USUAL,
            Optional.empty(),
            Literals.name(node),
            Map.of());
    if (graph.objects(node, COST).isEmpty()) {
      graph.fault(node, "has no maestro:cost", "write a number, an expression, or maestro:asked");
    }
    return read(node, blank);
  }

  /** What is told of a feature that has no sentence of its own. */
  private String spoken(Node node) {
    String inputs =
        parameters(node, "input", List.of()).stream()
            .map(input -> "{" + input.name() + "}")
            .collect(Collectors.joining(", "));
    return "{self} runs " + literals.label(node) + (inputs.isEmpty() ? "" : " (" + inputs + ")");
  }

  /** The feature type with what the node says otherwise. */
  public FeatureType read(Node node, FeatureType type) {
    Price price = price(node).orElse(type.cost());
    Timing timing = timing(node).or(type.timing());
    return new FeatureType(
        type.name(),
        type.iri(),
        type.task(),
        literals.text(node, "sentence").orElse(type.sentence()),
        parameters(node, "input", type.inputs()),
        parameters(node, "binds", type.binds()),
        parameters(node, "output", type.outputs()),
        with(
            timing.meanwhile(),
            literals
                .parsed(node, "precondition", text -> SlParser.formula(text, fluents))
                .orElse(type.precondition())),
        effect(node, "effect").orElse(type.effect()),
        effect(node, "learns").or(type::learns),
        has(node, "continuous") ? literals.flag(node, "continuous") : type.continuous(),
        literals.text(node, "endedBy").or(type::endedBy),
        frequency(node, type.frequencyHertz()),
        has(node, "occupies")
            ? new LinkedHashSet<>(literals.names(node, "occupies"))
            : type.occupies(),
        has(node, "claims") ? claims(node) : type.claims(),
        has(node, "confidence") ? doubts(node) : type.doubts(),
        price,
        literals
            .parsed(node, "seconds", SlParser::expression)
            .orElse(has(node, "cost") ? lowest(price) : type.seconds()),
        timing,
        reliability(node).or(type.reliability()),
        literals.text(node, "exit").or(type::exit),
        literals.text(node, "procedure").orElse(type.procedure()),
        namedFacts(node, "refersTo", type.refersTo()));
  }

  private Timing timing(Node node) {
    Timing timing =
        new Timing(
            duration(node, "timeLimit"),
            duration(node, "grace"),
            literals.parsed(node, "meanwhile", text -> SlParser.formula(text, fluents)),
            literals.parsed(node, "doneWhen", text -> SlParser.formula(text, fluents)),
            duration(node, "effectAfter"));
    if (timing.doneWhen().isPresent() && timing.effectAfter().isPresent()) {
      graph.fault(
          node,
          Maestro.term("effectAfter"),
          Optional.empty(),
          "is said beside maestro:doneWhen",
          "keep one of both");
    }
    return timing;
  }

  /** What has to hold meanwhile has to hold at the beginning, too; said once if said twice. */
  private static Formula with(Optional<Formula> meanwhile, Formula precondition) {
    if (meanwhile.isEmpty() || meanwhile.get().equals(precondition)) {
      return precondition;
    }
    List<Formula> parts =
        new ArrayList<>(
            precondition instanceof Formula.And and ? and.operands() : List.of(precondition));
    if (!parts.contains(meanwhile.get())) {
      parts.add(meanwhile.get());
    }
    return parts.size() == 1 ? parts.get(0) : new Formula.And(parts);
  }

  private Reliability reliability(Node node) {
    return new Reliability(
        number(node, "chance", chance -> chance > 0 && chance <= 1, "above 0 and at most 1")
            .filter(chance -> chance < 1),
        number(
                node,
                "tries",
                tries -> tries >= 1 && tries <= 100 && tries == Math.rint(tries),
                "from 1 to 100, whole")
            .map(Double::intValue));
  }

  private Optional<Double> number(
      Node node, String property, DoublePredicate isRight, String right) {
    OptionalDouble number = literals.number(node, property);
    if (number.isPresent() && !isRight.test(number.getAsDouble())) {
      graph.fault(
          node,
          Maestro.term(property),
          Optional.empty(),
          "is " + SlPrinter.print(number.getAsDouble()),
          "write a number " + right);
      return Optional.empty();
    }
    return number.stream().boxed().findFirst();
  }

  private Optional<Duration> duration(Node node, String property) {
    OptionalDouble seconds = literals.number(node, property);
    if (seconds.isPresent() && !(seconds.getAsDouble() > 0 && seconds.getAsDouble() <= LONGEST)) {
      graph.fault(
          node,
          Maestro.term(property),
          Optional.empty(),
          "is no time that a call can have",
          "write seconds, more than 0 and up to a week");
      return Optional.empty();
    }
    return seconds.stream()
        .mapToObj(limit -> Duration.ofMillis(Math.max(1, Math.round(limit * 1000))))
        .findFirst();
  }

  /**
   * Names and facts, as {@code maestro:refersTo} and {@code maestro:reports} give them, over what
   * holds without.
   */
  public Map<String, String> namedFacts(Node node, String property, Map<String, String> before) {
    Map<String, String> facts = new TreeMap<>(before);
    for (Node entry : graph.objects(node, Maestro.term(property))) {
      Optional<String> name = literals.text(entry, "name");
      Optional<String> fact =
          literals.parsed(entry, "fact", text -> SlPrinter.print(SlParser.fact(text)));
      if (name.isPresent() && fact.isPresent()) {
        facts.put(name.get(), fact.get());
      } else if (name.isEmpty() || !has(entry, "fact")) {
        graph.fault(
            node,
            Maestro.term(property),
            Optional.of(entry),
            "lacks its maestro:name or maestro:fact",
            graph.inItsSyntax(
                "write [ maestro:name \"level\" ; maestro:fact \"(level ?self)\" ]",
                "write {\"name\": \"level\", \"fact\": \"(level ?self)\"}"));
      }
    }
    return facts;
  }

  private List<Claim> claims(Node node) {
    Map<String, Claim> claims = new TreeMap<>();
    for (Node entry : graph.objects(node, Maestro.term("claims"))) {
      Optional<TypedVariable> variable = literals.parsed(entry, "variable", SlParser::variable);
      Optional<Formula> when =
          literals.parsed(entry, "when", text -> SlParser.formula(text, fluents));
      if (variable.isPresent() && when.isPresent()) {
        claims.put(
            variable.get().name() + SlPrinter.print(when.get()),
            new Claim(variable.get(), when.get()));
      } else if (!has(entry, "variable") || !has(entry, "when")) {
        graph.fault(
            node,
            Maestro.term("claims"),
            Optional.of(entry),
            "lacks its maestro:variable or maestro:when",
            graph.inItsSyntax(
                "write [ maestro:variable \"?t - Thing\" ; maestro:when \"(...)\" ]",
                "write {\"variable\": \"?t - Thing\", \"when\": \"(...)\"}"));
      }
    }
    return List.copyOf(claims.values());
  }

  /** A number alone holds always; a node says under which formula. */
  private List<Doubt> doubts(Node node) {
    Map<String, Doubt> doubts = new TreeMap<>();
    for (Node entry : graph.objects(node, Maestro.term("confidence"))) {
      OptionalDouble number =
          entry.isBlank()
              ? literals.number(entry, "upTo")
              : Literals.term(entry) instanceof Term.Number stated
                  ? OptionalDouble.of(stated.value())
                  : OptionalDouble.empty();
      Optional<Formula> when =
          entry.isBlank()
              ? literals.parsed(entry, "when", text -> SlParser.formula(text, fluents))
              : Optional.of(new Formula.And(List.of()));
      if (!entry.isBlank()
          && number.isPresent()
          && (number.getAsDouble() < 0 || number.getAsDouble() > 1)) {
        graph.fault(
            node,
            Maestro.term("confidence"),
            Optional.of(entry),
            "is not a number from 0 to 1",
            "write how sure the results are, such as 0.8");
      } else if (number.isPresent() && when.isPresent()) {
        Doubt doubt = new Doubt(number.getAsDouble(), when.get());
        doubts.put(SlPrinter.print(doubt.when()) + doubt.confidence(), doubt);
      } else if (number.isEmpty() || !has(entry, "when")) {
        graph.fault(
            node,
            Maestro.term("confidence"),
            Optional.of(entry),
            "is neither a number nor a node with maestro:upTo and maestro:when",
            graph.inItsSyntax(
                "write 0.8, or [ maestro:upTo 0.4 ; maestro:when \"(...)\" ]",
                "write 0.8, or {\"upTo\": 0.4, \"when\": \"(...)\"}"));
      }
    }
    return List.copyOf(doubts.values());
  }

  private Optional<Effect> effect(Node node, String property) {
    return literals.parsed(node, property, text -> SlParser.effect(text, fluents));
  }

  private boolean has(Node node, String property) {
    return !graph.objects(node, Maestro.term(property)).isEmpty();
  }

  private Optional<Price> price(Node node) {
    if (graph.objects(node, COST).contains(Maestro.term("asked"))) {
      Expression atLeast =
          literals
              .parsed(node, "costAtLeast", SlParser::expression)
              .orElse(new Expression.OfTerm(new Term.Number(0)));
      return Optional.of(new Price.Asked(atLeast));
    }
    return literals.parsed(node, "cost", SlParser::expression).map(Price.Stated::new);
  }

  private static Expression lowest(Price price) {
    return price instanceof Price.Stated stated ? stated.cost() : ((Price.Asked) price).atLeast();
  }

  private OptionalDouble frequency(Node node, OptionalDouble before) {
    Optional<Node> value = graph.object(node, Maestro.term("frequency"));
    if (value.isEmpty()) {
      return before;
    }
    OptionalDouble hertz =
        value.get().isBlank()
            ? literals.number(value.get(), "upTo")
            : literals.number(node, "frequency");
    if (hertz.isPresent() && hertz.getAsDouble() <= 0) {
      graph.fault(
          node,
          Maestro.term("frequency"),
          Optional.empty(),
          "is not a number above 0",
          "write how often it repeats each second, such as 30");
    }
    return hertz;
  }

  private List<Parameter> parameters(Node node, String property, List<Parameter> before) {
    Map<String, Parameter> byName = new TreeMap<>();
    before.forEach(parameter -> byName.put(parameter.name(), parameter));
    Set<String> here = new LinkedHashSet<>();
    for (Node entry : graph.objects(node, Maestro.term(property))) {
      Optional<String> name = literals.text(entry, "name");
      if (name.isEmpty()) {
        graph.fault(
            node,
            Maestro.term(property),
            Optional.of(entry),
            "lacks its maestro:name",
            graph.inItsSyntax(
                "write [ maestro:name \"object\" ; maestro:type maestro:Thing ]",
                "write {\"name\": \"object\", \"types\": [\"maestro:Thing\"]}"));
      } else if (!here.add(name.get())) {
        graph.fault(
            node,
            Maestro.term(property),
            Optional.of(entry),
            "names " + name.get() + " twice",
            "keep one of both; what may be of several classes has them in one list");
      } else {
        byName.merge(name.get(), parameter(entry, name.get()), FeatureReader::over);
      }
    }
    return List.copyOf(byName.values());
  }

  private Parameter parameter(Node entry, String name) {
    return new Parameter(
        name,
        sorted(literals.names(entry, "type")),
        literals.terms(entry, "oneOf"),
        sorted(literals.names(entry, "needs")),
        literals.flag(entry, "optional"));
  }

  private static List<String> sorted(Collection<String> names) {
    List<String> sorted = new ArrayList<>(names);
    sorted.sort(null);
    return sorted;
  }

  /** What a description says otherwise of a parameter. */
  private static Parameter over(Parameter before, Parameter given) {
    return new Parameter(
        before.name(),
        given.types().isEmpty() ? before.types() : given.types(),
        given.oneOf().isEmpty() ? before.oneOf() : given.oneOf(),
        given.needs().isEmpty() ? before.needs() : given.needs(),
        given.optional() || before.optional());
  }
}
