package org.maestro.agents;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.knowledge.Belief;
import org.maestro.knowledge.FeatureRun;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.knowledge.Snapshot;
import org.maestro.knowledge.Source;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;

/** The collective knowledge, with only those devices to plan with that are in an agent's scope. */
final class ScopedKnowledge implements KnowledgeBase {
  private final KnowledgeBase knowledge;
  private final Predicate<String> scope;

  ScopedKnowledge(KnowledgeBase knowledge, Predicate<String> scope) {
    this.knowledge = knowledge;
    this.scope = scope;
  }

  @Override
  public Home home() {
    Home home = knowledge.home();
    Map<String, Device> devices = new TreeMap<>(home.devices());
    devices.keySet().removeIf(scope.negate());
    return new Home(
        home.iri(), home.label(), home.vocabulary(), home.individuals(), devices, home.groups());
  }

  @Override
  public void describe(Device device) {
    knowledge.describe(device);
  }

  @Override
  public void state(Source source, List<String> facts) {
    knowledge.state(source, facts);
  }

  @Override
  public Change learn(FeatureRun run) {
    return knowledge.learn(run);
  }

  @Override
  public void lost(String member) {
    // Only the central agent, which hears of all members, says so for all.
  }

  @Override
  public Snapshot snapshot() {
    return knowledge.snapshot();
  }

  @Override
  public List<Belief> history(String fact) {
    return knowledge.history(fact);
  }

  @Override
  public Optional<Belief> lastKnown(String fact) {
    return knowledge.lastKnown(fact);
  }

  @Override
  public void watch(Consumer<Change> listener) {
    knowledge.watch(listener);
  }

  @Override
  public void close() {
    // It is closed by who opened it.
  }
}
