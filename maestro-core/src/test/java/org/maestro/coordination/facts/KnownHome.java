package org.maestro.coordination.facts;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/** A home and what is known in it, of which single questions are asked. */
final class KnownHome {
  final SteppedClock clock = new SteppedClock();
  final Home home;
  final Vocabulary vocabulary;
  final KnowledgeBase knowledge;

  private KnownHome(String file) {
    try (InputStream turtle = KnownHome.class.getResourceAsStream(file)) {
      home = new HomeLoader().load(new String(turtle.readAllBytes(), StandardCharsets.UTF_8), file);
    } catch (IOException unreadable) {
      throw new UncheckedIOException(unreadable);
    }
    vocabulary = home.vocabulary();
    knowledge = new CollectiveKnowledge(home, clock);
  }

  static KnownHome ofBob() {
    return new KnownHome("/bob.ttl");
  }

  static KnownHome workshop() {
    return new KnownHome("/workshop.ttl");
  }

  /** Bob's home, with Rose and the cup in room B, where it is rather dark. */
  static KnownHome withRoseAtTheCup() {
    KnownHome known = ofBob();
    known.told("rose", "(in rose zone-b)");
    known.told("lamp-b1", "(= (level lamp-b1) 0)");
    known.seen("cam-b", "(in Cup zone-b)");
    known.seen("lux-b", "(= (illuminance zone-b) 17)");
    return known;
  }

  void seen(String observer, String... facts) {
    knowledge.state(new Source(Source.Kind.OBSERVED, observer), List.of(facts));
  }

  void told(String member, String... facts) {
    knowledge.state(new Source(Source.Kind.STATED, member), List.of(facts));
  }

  /** The step's own result says that it is done. */
  void done(Step step) {
    knowledge.learn(
        new FeatureRun(
            step.member(),
            step.feature(),
            Self.is(step.member(), step.bindings()),
            true,
            Map.of(),
            List.of()));
  }

  void pass(Duration time) {
    Duration until = clock.now().plus(time);
    clock.schedule(time, "test", () -> {});
    clock.runUntil(() -> clock.now().compareTo(until) >= 0, time.multipliedBy(2));
  }

  Snapshot now() {
    return knowledge.snapshot();
  }

  Formula formula(String text) {
    return SlParser.formula(text, vocabulary::isFluent);
  }

  Formula.Atom atom(String text) {
    return (Formula.Atom) formula(text);
  }

  static Expression.Fluent fluent(String text) {
    return (Expression.Fluent) SlParser.expression(text);
  }

  Effect effect(String text) {
    return SlParser.effect(text, vocabulary::isFluent);
  }

  FeatureType feature(String member, String name) {
    return home.devices().get(member).features().stream()
        .filter(type -> type.name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  /** The changes of these facts, as knowledge tells them. */
  FactFilter changes(String... facts) {
    return FactFilter.of(List.of(facts), vocabulary);
  }

  /**
   * @param values of parameters: {@code object=Cup}
   */
  Step step(String member, String feature, String... values) {
    Map<String, Term> bindings = new TreeMap<>();
    for (String value : values) {
      String[] parts = value.split("=");
      bindings.put(parts[0], SlParser.term(parts[1]));
    }
    return new Step(1, member, feature(member, feature), bindings, 1, 1, true, Set.of());
  }
}
