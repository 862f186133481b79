package org.maestro.agents.content;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Argument;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.planning.api.Step;
import org.maestro.rats.protocol.Outcome;
import org.maestro.sl.Content;
import org.maestro.sl.Term;

/**
 * The wording of orders: {@code (perform (:goal G1) (:feature pick) (:parameters (:object Cup
 * ...)))}.
 */
public final class Orders {

  private Orders() {}

  public static Content step(String goalId, Step step) {
    return Words.content(
        "perform",
        Words.named("goal", Words.name(goalId)),
        Words.named("feature", Words.name(step.feature().name())),
        Words.terms("parameters", new TreeMap<>(step.bindings())));
  }

  /**
   * @param caller the agent that orders: each names calls by itself, and members take all of them
   *     for calls of one controller
   * @param receiver the agent that is ordered
   * @param client for whom it orders, where that matters
   */
  public static Content order(
      ActionDispatcher.Request order, String caller, String receiver, Optional<String> client) {
    List<Content.Argument> arguments = new ArrayList<>();
    arguments.addAll(member(order.step().member(), receiver));
    arguments.add(Words.named("goal", Words.name(order.goalId())));
    order.call().ifPresent(call -> arguments.addAll(call(call, caller)));
    client.ifPresent(name -> arguments.add(Words.named("for", Words.text(name))));
    arguments.add(Words.named("feature", Words.name(order.step().feature().name())));
    arguments.add(Words.named("timeout", Words.number((double) order.timeout().toMillis())));
    arguments.add(Words.named("cost", Words.number(order.step().cost())));
    arguments.add(Words.named("seconds", Words.number(order.step().seconds())));
    arguments.add(parameters("parameters", order.parameters()));
    if (order.ends()) {
      arguments.add(Words.named("ends", Words.name("true")));
    }
    return new Content("perform", arguments);
  }

  /**
   * For no goal, at once.
   *
   * @param receiver the agent that is ordered
   */
  public static Content plain(
      String member,
      String receiver,
      String feature,
      Duration timeout,
      Map<String, Argument> parameters) {
    List<Content.Argument> arguments = new ArrayList<>(member(member, receiver));
    arguments.add(Words.named("feature", Words.name(feature)));
    arguments.add(Words.named("timeout", Words.number((double) timeout.toMillis())));
    arguments.add(parameters("parameters", parameters));
    return new Content("perform", arguments);
  }

  /**
   * For no goal, of a feature that goes on: each of its observations is told to who orders it, by
   * CONFIRM, and to nobody else.
   *
   * @param receiver the agent that is ordered
   */
  public static Content watched(String member, String receiver, String feature) {
    List<Content.Argument> arguments = new ArrayList<>(member(member, receiver));
    arguments.add(Words.named("feature", Words.name(feature)));
    arguments.add(Words.named("watch", Words.name("true")));
    return new Content("perform", arguments);
  }

  /** Of a call that was ordered by a coordinator before this one. */
  public static Content callOff(
      ActionDispatcher.Call call, String caller, String member, String receiver) {
    List<Content.Argument> arguments = new ArrayList<>(member(member, receiver));
    arguments.addAll(call(call, caller));
    return new Content("cancel", arguments);
  }

  /** Which member is meant, where that does not follow from the agent that is spoken to. */
  public static List<Content.Argument> member(String member, String receiver) {
    return member.equals(receiver) ? List.of() : List.of(Words.named("member", Words.name(member)));
  }

  private static List<Content.Argument> call(ActionDispatcher.Call call, String caller) {
    List<Content.Argument> name = new ArrayList<>();
    name.add(Words.named("call", Words.text(caller + "-" + call.id())));
    call.life().ifPresent(life -> name.add(Words.named("life", Words.text(life))));
    return name;
  }

  public static Content.Argument.Named parameters(String title, Map<String, Argument> parameters) {
    List<Content.Argument> named = new ArrayList<>();
    parameters.forEach((name, argument) -> named.add(parameter(name, argument)));
    return Words.named(title, named);
  }

  private static Content.Argument parameter(String name, Argument argument) {
    List<Content.Argument> parts = new ArrayList<>();
    parts.add(Words.term(argument.value()));
    argument.iri().ifPresent(iri -> parts.add(Words.named("iri", Words.text(iri))));
    argument
        .properties()
        .forEach(
            (property, values) ->
                parts.add(Words.named(property, values.stream().map(Words::term).toList())));
    return Words.named(name, parts);
  }

  /**
   * An order for no goal, as by hand.
   *
   * @param client for whom it is asked, where that matters
   * @param timeout simulated time that it may take
   */
  public static Content byHand(
      String member,
      String receiver,
      String feature,
      Map<String, Argument> parameters,
      Optional<String> client,
      Duration timeout) {
    List<Content.Argument> arguments = new ArrayList<>(member(member, receiver));
    client.ifPresent(name -> arguments.add(Words.named("for", Words.text(name))));
    arguments.add(Words.named("feature", Words.name(feature)));
    arguments.add(Words.named("timeout", Words.number((double) timeout.toMillis())));
    arguments.add(parameters("parameters", parameters));
    return new Content("perform", arguments);
  }

  /** How a step failed. */
  public static Content failure(Outcome outcome, ActionDispatcher.Report report) {
    List<Content.Argument> refs = new ArrayList<>();
    for (FeatureRun.Learnt ref : report.refs()) {
      List<Content.Argument> terms = new ArrayList<>();
      terms.add(Words.text(ref.fact()));
      terms.add(Words.term(ref.value()));
      ref.need().map(Words::text).ifPresent(terms::add);
      refs.add(Words.named("fact", terms));
    }
    List<Content.Argument> words = new ArrayList<>();
    words.add(Words.named("outcome", Words.name(outcome.name().toLowerCase(Locale.ROOT))));
    words.add(Words.named("begun", Words.name(String.valueOf(report.begun()))));
    if (report.unanswered()) {
      words.add(Words.named("unanswered", Words.name("true")));
    }
    report.refusal().ifPresent(kind -> words.add(Words.named("refused", Words.name(word(kind)))));
    words.add(Words.named("problem", Words.text(report.problem().orElse("no reason given"))));
    words.add(Words.named("refs", refs));
    return new Content("inform", words);
  }

  /** How long what is refused is refused. */
  private static String word(ActionDispatcher.Refusal refusal) {
    return refusal.name().toLowerCase(Locale.ROOT).replace('_', '-');
  }

  public static Optional<ActionDispatcher.Refusal> refusal(Words words) {
    Optional<String> told = words.string("refused");
    return Arrays.stream(ActionDispatcher.Refusal.values())
        .filter(kind -> told.filter(word(kind)::equals).isPresent())
        .findFirst();
  }

  /** What {@link #parameters} wrote. */
  public static Map<String, Argument> arguments(Words words) {
    Map<String, Argument> arguments = new LinkedHashMap<>();
    for (Content.Argument.Named named : words.all()) {
      Words parts = Words.of(named);
      Map<String, List<Term>> properties = new TreeMap<>();
      for (Content.Argument.Named property : parts.all()) {
        if (!property.name().equals("iri")) {
          properties.put(property.name(), Words.of(property).terms());
        }
      }
      Optional<String> iri = parts.string("iri");
      parts.terms().stream()
          .findFirst()
          .ifPresent(value -> arguments.put(named.name(), new Argument(value, iri, properties)));
    }
    return arguments;
  }
}
