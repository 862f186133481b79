package org.maestro.platform.journal;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.GoalEffort;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.Stakes;
import org.maestro.coordination.journal.JournalImage.Dated;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * The JSON of journal entries. Goals and values are MAESTRO-SL, times are seconds of the clock that
 * the journal's first line names.
 */
final class JournalCodec {
  private static final ObjectMapper JSON = new ObjectMapper();

  private final Predicate<String> fluents;
  private final MemoryCodec memories;

  /**
   * @param fluents which predicates have numbers as values
   */
  JournalCodec(Predicate<String> fluents) {
    this.fluents = fluents;
    this.memories = new MemoryCodec(fluents);
  }

  ObjectNode write(Dated dated) {
    ObjectNode line = JSON.createObjectNode();
    line.put("at_s", seconds(dated.at()));
    JournalEntry entry = dated.entry();
    if (entry instanceof JournalEntry.Submitted submitted) {
      event(line, "submitted", submitted.goalId());
      line.put("asks", SlPrinter.print(submitted.request().goal()));
      line.put("requester", submitted.request().requester());
      line.put("priority", submitted.request().priority());
      submitted.request().deadline().ifPresent(at -> line.put("deadline_s", seconds(at)));
      submitted.request().stakes().ifPresent(stakes -> stakes(line.putObject("stakes"), stakes));
    } else if (entry instanceof JournalEntry.Withdrawn withdrawn) {
      event(line, "withdrawn", withdrawn.goalId());
    } else if (entry instanceof JournalEntry.Became became) {
      event(line, "became", became.goalId());
      line.put("state", word(became.state()));
      line.put("reason", became.reason());
      line.put("plans", became.effort().plans());
      line.put("confirming", became.effort().confirmingPlans());
      line.put("calls", became.effort().calls());
    } else if (entry instanceof JournalEntry.Keeps keeps) {
      event(line, "keeps", keeps.goalId());
      ArrayNode components = line.putArray("components");
      new TreeSet<>(keeps.components())
          .forEach(c -> components.addArray().add(c.owner()).add(c.part()));
      ArrayNode carried = line.putArray("carried");
      keeps.carried().stream().map(SlPrinter::print).sorted().forEach(carried::add);
      ObjectNode changed = line.putObject("changed");
      keeps.broughtAbout().forEach((name, of) -> of.forEach(changed.withArray(name)::add));
    } else if (entry instanceof JournalEntry.Begun begun) {
      begun(line, begun);
    } else if (entry instanceof JournalEntry.Established established) {
      event(line, "established", established.goalId()).put("call", established.callId());
    } else if (entry instanceof JournalEntry.CalledOff calledOff) {
      event(line, "called-off", calledOff.goalId()).put("call", calledOff.callId());
    } else if (entry instanceof JournalEntry.NotBegun notBegun) {
      event(line, "not-begun", notBegun.goalId()).put("call", notBegun.callId());
    } else if (entry instanceof JournalEntry.Ended ended) {
      event(line, "ended", ended.goalId()).put("call", ended.callId());
      ended.problem().ifPresent(problem -> line.put("problem", problem));
    } else if (entry instanceof JournalEntry.Over over) {
      over(line, over.outcome());
    } else if (entry instanceof JournalEntry.OfGoal learnt) {
      memories.write(line, learnt);
    } else if (entry instanceof JournalEntry.MemberCame came) {
      line.put("event", "came").put("member", came.member());
      came.life().ifPresent(life -> line.put("life", life));
    } else if (entry instanceof JournalEntry.MemberWent went) {
      line.put("event", "went").put("member", went.member()).put("reason", went.reason());
    }
    return line;
  }

  private static void stakes(ObjectNode node, Stakes stakes) {
    node.put("benefit", SlPrinter.print(stakes.benefit()));
    node.put("chance", stakes.chance());
    stakes.allowed().ifPresent(time -> node.put("allowed_s", seconds(time)));
    node.put("urgency_from", stakes.urgencyFrom());
    node.put("urgency_to", stakes.urgencyTo());
  }

  private static Stakes readStakes(JsonNode node) {
    return new Stakes(
        SlParser.expression(node.path("benefit").asText()),
        node.path("chance").asDouble(),
        Optional.of(node.path("allowed_s"))
            .filter(JsonNode::isNumber)
            .map(seconds -> Duration.ofMillis(Math.round(seconds.asDouble() * 1000))),
        node.path("urgency_from").asDouble(),
        node.path("urgency_to").asDouble());
  }

  static ObjectNode event(ObjectNode line, String event, String goalId) {
    return line.put("event", event).put("goal", goalId);
  }

  private static void begun(ObjectNode line, JournalEntry.Begun begun) {
    event(line, "begun", begun.goalId());
    line.put("call", begun.call().id());
    begun.call().life().ifPresent(life -> line.put("life", life));
    line.put("step", begun.number());
    step(line, begun.step());
    ObjectNode parameters = line.putObject("parameters");
    begun.parameters().forEach((name, argument) -> argument(parameters.putObject(name), argument));
    line.put("seconds", begun.seconds());
    line.put("timeout_ms", begun.timeout().toMillis());
  }

  static void step(ObjectNode node, StepKey step) {
    node.put("member", step.member());
    node.put("feature", step.feature());
    terms(node.putObject("bindings"), step.bindings());
  }

  static StepKey readStep(JsonNode node) {
    return new StepKey(
        node.path("member").asText(),
        node.path("feature").asText(),
        readTerms(node.path("bindings")));
  }

  private static void argument(ObjectNode node, Argument argument) {
    node.put("value", SlPrinter.print(argument.value()));
    argument.iri().ifPresent(iri -> node.put("iri", iri));
    if (!argument.properties().isEmpty()) {
      ObjectNode properties = node.putObject("properties");
      argument
          .properties()
          .forEach(
              (property, values) -> {
                ArrayNode list = properties.putArray(property);
                values.forEach(value -> list.add(SlPrinter.print(value)));
              });
    }
  }

  private static void over(ObjectNode line, GoalOutcome outcome) {
    event(line, "over", outcome.id());
    line.put("asked", outcome.goal());
    line.put("state", word(outcome.state()));
    line.put("confirmed", outcome.confirmed());
    terms(line.putObject("binding"), outcome.binding());
    outcome.reasons().forEach(line.putArray("reasons")::add);
    line.put("calls", outcome.calls());
    line.put("replans", outcome.replans());
    line.put("submitted_s", seconds(outcome.submittedAt()));
    line.put("decision_ms", outcome.decisionMillis());
  }

  private static void terms(ObjectNode node, Map<String, Term> terms) {
    new TreeMap<>(terms).forEach((name, term) -> node.put(name, SlPrinter.print(term)));
  }

  /**
   * Reads what {@link #write} wrote.
   *
   * @param from of the journal's times
   * @param to in which they are wanted
   */
  Dated read(JsonNode line, Timeline from, Timeline to) throws JournalDamage {
    try {
      Duration at = time(line, "at_s", from, to);
      return new Dated(at, entry(line, at, from, to));
    } catch (RuntimeException unreadable) {
      throw new JournalDamage("its fields make no sense: " + unreadable.getMessage(), false);
    }
  }

  private JournalEntry entry(JsonNode line, Duration at, Timeline from, Timeline to) {
    String goal = line.path("goal").asText();
    String call = line.path("call").asText();
    String event = line.path("event").asText();
    return switch (event) {
      case "submitted" ->
          new JournalEntry.Submitted(
              goal,
              new GoalRequest(
                  SlParser.formula(line.path("asks").asText(), fluents),
                  line.path("requester").asText(),
                  line.path("priority").asInt(),
                  Optional.of(line)
                      .filter(l -> l.has("deadline_s"))
                      .map(l -> time(l, "deadline_s", from, to)),
                  Optional.of(line.path("stakes"))
                      .filter(JsonNode::isObject)
                      .map(JournalCodec::readStakes)));
      case "withdrawn" -> new JournalEntry.Withdrawn(goal);
      case "became" ->
          new JournalEntry.Became(
              goal,
              state(line),
              line.path("reason").asText(),
              new GoalEffort(
                  line.path("plans").asInt(),
                  line.path("confirming").asInt(),
                  line.path("calls").asInt()));
      case "keeps" -> readKeeps(line, goal);
      case "begun" -> readBegun(line, goal, call);
      case "established" -> new JournalEntry.Established(goal, call);
      case "called-off" -> new JournalEntry.CalledOff(goal, call);
      case "not-begun" -> new JournalEntry.NotBegun(goal, call);
      case "ended" -> new JournalEntry.Ended(goal, call, text(line, "problem"));
      case "over" -> new JournalEntry.Over(readOutcome(line, goal, at, from, to));
      case "came" -> new JournalEntry.MemberCame(line.path("member").asText(), text(line, "life"));
      case "went" ->
          new JournalEntry.MemberWent(line.path("member").asText(), line.path("reason").asText());
      default -> memories.read(event, line, goal, from, to);
    };
  }

  private JournalEntry.Keeps readKeeps(JsonNode line, String goal) {
    Set<Resource> components = new TreeSet<>();
    line.path("components")
        .forEach(c -> components.add(Resource.component(c.path(0).asText(), c.path(1).asText())));
    Set<Formula.Atom> carried = new LinkedHashSet<>();
    for (JsonNode fact : line.path("carried")) {
      if (SlParser.formula(fact.asText(), fluents) instanceof Formula.Atom atom) {
        carried.add(atom);
      }
    }
    Map<String, Set<String>> changed = new TreeMap<>();
    line.path("changed")
        .properties()
        .forEach(
            of -> {
              Set<String> names = new TreeSet<>();
              of.getValue().forEach(name -> names.add(name.asText()));
              changed.put(of.getKey(), names);
            });
    return new JournalEntry.Keeps(goal, components, carried, changed);
  }

  private static JournalEntry.Begun readBegun(JsonNode line, String goal, String call) {
    Map<String, Argument> parameters = new LinkedHashMap<>();
    line.path("parameters")
        .properties()
        .forEach(entry -> parameters.put(entry.getKey(), readArgument(entry.getValue())));
    return new JournalEntry.Begun(
        goal,
        new ActionDispatcher.Call(call, text(line, "life")),
        readStep(line),
        line.path("step").asInt(),
        line.path("seconds").asDouble(),
        parameters,
        Duration.ofMillis(line.path("timeout_ms").asLong()));
  }

  private static Argument readArgument(JsonNode node) {
    Map<String, List<Term>> properties = new TreeMap<>();
    node.path("properties")
        .properties()
        .forEach(
            property -> {
              List<Term> values = new ArrayList<>();
              property.getValue().forEach(value -> values.add(SlParser.term(value.asText())));
              properties.put(property.getKey(), values);
            });
    return new Argument(SlParser.term(node.path("value").asText()), text(node, "iri"), properties);
  }

  private static GoalOutcome readOutcome(
      JsonNode line, String goal, Duration endedAt, Timeline from, Timeline to) {
    List<String> reasons = new ArrayList<>();
    line.path("reasons").forEach(reason -> reasons.add(reason.asText()));
    return new GoalOutcome(
        goal,
        line.path("asked").asText(),
        state(line),
        line.path("confirmed").asBoolean(),
        readTerms(line.path("binding")),
        reasons,
        line.path("calls").asInt(),
        line.path("replans").asInt(),
        time(line, "submitted_s", from, to),
        endedAt,
        line.path("decision_ms").asDouble());
  }

  private static Map<String, Term> readTerms(JsonNode node) {
    Map<String, Term> terms = new TreeMap<>();
    node.properties()
        .forEach(entry -> terms.put(entry.getKey(), SlParser.term(entry.getValue().asText())));
    return terms;
  }

  private static Optional<String> text(JsonNode node, String field) {
    return Optional.ofNullable(node.path(field).textValue());
  }

  private static GoalState state(JsonNode line) {
    return GoalState.valueOf(line.path("state").asText().toUpperCase(Locale.ROOT));
  }

  private static String word(GoalState state) {
    return state.name().toLowerCase(Locale.ROOT);
  }

  static BigDecimal seconds(Duration duration) {
    return BigDecimal.valueOf(duration.toMillis(), 3);
  }

  static Duration time(JsonNode line, String field, Timeline from, Timeline to) {
    double seconds = line.path(field).asDouble();
    return from.translate(Duration.ofMillis(Math.round(seconds * 1000)), to);
  }
}
