package org.maestro.knowledge.api;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Group;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.home.NamedPoints;

/**
 * A view of a knowledge base, for those who see it in a way of their own: everything is asked of it
 * but what a subclass says otherwise. It is closed by who opened it, so that closing a view does
 * nothing.
 */
public abstract class ForwardingKnowledge implements KnowledgeBase {
  private final KnowledgeBase knowledge;

  protected ForwardingKnowledge(KnowledgeBase knowledge) {
    this.knowledge = knowledge;
  }

  @Override
  public Home home() {
    return knowledge.home();
  }

  @Override
  public void permit(Map<String, Individual> permissions) {
    knowledge.permit(permissions);
  }

  @Override
  public void admit(Group group) {
    knowledge.admit(group);
  }

  @Override
  public void dismiss(String group) {
    knowledge.dismiss(group);
  }

  @Override
  public void admit(NamedPoints points) {
    knowledge.admit(points);
  }

  @Override
  public void dismiss(NamedPoints points) {
    knowledge.dismiss(points);
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
  public void state(String member, MemberWord word) {
    knowledge.state(member, word);
  }

  @Override
  public void condition(String member, MemberCondition now) {
    knowledge.condition(member, now);
  }

  @Override
  public void believe(Source source, Map<String, Double> sureness) {
    knowledge.believe(source, sureness);
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
  public boolean doubt(List<String> conditions) {
    return knowledge.doubt(conditions);
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
  public QueryAnswer query(String sparql) {
    return knowledge.query(sparql);
  }

  @Override
  public void watch(Consumer<Change> listener) {
    knowledge.watch(listener);
  }

  @Override
  public final void close() {
    // It is closed by who opened it.
  }
}
