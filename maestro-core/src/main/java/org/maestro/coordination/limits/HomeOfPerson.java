package org.maestro.coordination.limits;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.maestro.knowledge.api.ForwardingKnowledge;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.permission.Restrictions;

/** The collective knowledge, with the home as it is for a person. */
final class HomeOfPerson extends ForwardingKnowledge {
  private final Optional<String> person;
  private volatile @Nullable Seen last;

  /** A home, and the same for the person. */
  private record Seen(Home whole, Home home) {}

  HomeOfPerson(KnowledgeBase knowledge, Optional<String> person) {
    super(knowledge);
    this.person = person;
  }

  @Override
  @SuppressWarnings("ReferenceEquality") // Another state of the home is another object.
  public Home home() {
    Home whole = super.home();
    Seen seen = last;
    if (seen == null || seen.whole() != whole) {
      seen = new Seen(whole, Restrictions.of(whole).homeOf(person));
      last = seen;
    }
    return seen.home();
  }
}
