package org.maestro.coordination;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import org.maestro.knowledge.Belief;
import org.maestro.knowledge.FeatureRun;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.knowledge.Snapshot;
import org.maestro.knowledge.Source;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;

/** The collective knowledge as it looks to one goal. */
final class WatchedKnowledge implements KnowledgeBase {
  private final KnowledgeBase knowledge;
  private final UnaryOperator<Snapshot> look;

  WatchedKnowledge(KnowledgeBase knowledge, UnaryOperator<Snapshot> look) {
    this.knowledge = knowledge;
    this.look = look;
  }

  @Override
  public Home home() {
    return knowledge.home();
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
    knowledge.lost(member);
  }

  @Override
  public Snapshot snapshot() {
    return look.apply(knowledge.snapshot());
  }

  @Override
  public Optional<Belief> lastKnown(String fact) {
    return knowledge.lastKnown(fact);
  }

  @Override
  public List<Belief> history(String fact) {
    return knowledge.history(fact);
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
