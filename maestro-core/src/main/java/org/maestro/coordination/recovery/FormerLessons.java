package org.maestro.coordination.recovery;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.lessons.Experience;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.SlParser;
import org.maestro.sl.Term;

/**
 * Learns again, after a restart, what failures have taught before it: that a thing is heavier than
 * was thought. What can be observed is not believed again, for it may be otherwise by now.
 */
public final class FormerLessons {
  private final KnowledgeBase knowledge;
  private final Experience experience;

  public FormerLessons(KnowledgeBase knowledge, Experience experience) {
    this.knowledge = knowledge;
    this.experience = experience;
  }

  public void learnAgain(List<JournalEntry.Failed> failures) {
    for (JournalEntry.Failed failed : failures) {
      feature(failed.step())
          .ifPresent(
              type ->
                  experience.refused(failed.step(), type, failed.taught(), knowledge.snapshot()));
      List<FeatureRun.Learnt> lasting = failed.taught().stream().filter(this::lasts).toList();
      if (!lasting.isEmpty()) {
        feature(failed.step()).ifPresent(type -> learn(failed.step(), type, lasting));
      }
    }
  }

  private boolean lasts(FeatureRun.Learnt learnt) {
    return SlParser.expression(learnt.fact()) instanceof Expression.Fluent fact
        && knowledge
            .home()
            .vocabulary()
            .predicate(fact.name())
            .filter(declared -> !declared.observable())
            .isPresent();
  }

  private Optional<FeatureType> feature(StepKey step) {
    return Optional.ofNullable(knowledge.home().devices().get(step.member())).stream()
        .flatMap(device -> device.features().stream())
        .filter(type -> type.name().equals(step.feature()))
        .findFirst();
  }

  /** The step is not under way: it leaves nothing open. */
  private void learn(StepKey step, FeatureType type, List<FeatureRun.Learnt> lasting) {
    Map<String, Term> bindings = step.values();
    knowledge.learn(
        new FeatureRun(
            step.member(),
            type.withEffect(new Effect.All(List.of())),
            bindings,
            false,
            Map.of(),
            lasting));
  }
}
