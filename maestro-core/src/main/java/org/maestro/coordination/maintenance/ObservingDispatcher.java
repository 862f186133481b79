package org.maestro.coordination.maintenance;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.facts.Sensing;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.planning.api.StepKey;

/**
 * The crew as the plans of a held goal use it: what they set is noted, and observation of what the
 * goal speaks of goes on when the plan that began it is over.
 */
final class ObservingDispatcher implements ActionDispatcher {
  private final ActionDispatcher dispatcher;
  private final KnowledgeBase knowledge;
  private final Watch watch;
  private final OwnSettings settings;

  ObservingDispatcher(
      ActionDispatcher dispatcher, KnowledgeBase knowledge, Watch watch, OwnSettings settings) {
    this.dispatcher = dispatcher;
    this.knowledge = knowledge;
    this.watch = watch;
    this.settings = settings;
  }

  @Override
  public Handle perform(Request order, Consumer<Report> reported) {
    Snapshot before = knowledge.snapshot();
    boolean sets =
        !order.ends()
            && !order.step().feature().continuous()
            && !watch.concerns(order.step().feature(), knowledge.home());
    if (sets) {
      settings.begun(order.step(), before);
    }
    Handle[] performance = new Handle[1];
    performance[0] =
        dispatcher.perform(
            order,
            report -> {
              if (report.succeeded() && !order.ends()) {
                done(order, before, performance[0], sets);
              } else if (sets) {
                settings.failed(order.step());
              }
              reported.accept(report);
            });
    return new Handle() {
      @Override
      public void cancel() {
        if (!watch.keeps(performance[0])) {
          performance[0].cancel();
        }
      }

      @Override
      public Optional<Duration> aliveAt() {
        return performance[0].aliveAt();
      }
    };
  }

  private void done(Request order, Snapshot before, Handle performance, boolean sets) {
    if (sets) {
      settings.done(order.step(), before);
    } else if (watch.concerns(order.step().feature(), knowledge.home())
        || isSoWhileItGoesOn(order.step().feature())) {
      watch.keep(order.step(), performance, knowledge.snapshot(), knowledge.home());
    }
  }

  private static boolean isSoWhileItGoesOn(FeatureType feature) {
    return feature.continuous() && !Sensing.isIn(feature.effect());
  }

  @Override
  public boolean isOwed(String goalId, StepKey step) {
    return dispatcher.isOwed(goalId, step);
  }

  @Override
  public List<Request> giveUpOwed(String goalId, Predicate<StepKey> unwanted) {
    return dispatcher.giveUpOwed(goalId, unwanted);
  }

  @Override
  public void ask(String member, Runnable heard) {
    dispatcher.ask(member, heard);
  }

  @Override
  public void callOff(String member, Call call) {
    dispatcher.callOff(member, call);
  }
}
