package org.maestro.coordination.facts;

import java.util.function.UnaryOperator;
import org.maestro.knowledge.api.ForwardingKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;

/** The collective knowledge as it looks to one goal. */
public final class WatchedKnowledge extends ForwardingKnowledge {
  private final UnaryOperator<Snapshot> look;

  public WatchedKnowledge(KnowledgeBase knowledge, UnaryOperator<Snapshot> look) {
    super(knowledge);
    this.look = look;
  }

  @Override
  public Snapshot snapshot() {
    return look.apply(super.snapshot());
  }
}
