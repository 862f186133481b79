package org.maestro.coordination;

import java.util.function.Consumer;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.knowledge.Snapshot;

/**
 * The crew as the plans of a held goal use it: what they set is noted, and observation of what the
 * goal speaks of goes on when the plan that began it is over.
 */
final class HeldCrew implements Crew {
  private final Crew crew;
  private final KnowledgeBase knowledge;
  private final Watch watch;
  private final OwnSettings settings;

  HeldCrew(Crew crew, KnowledgeBase knowledge, Watch watch, OwnSettings settings) {
    this.crew = crew;
    this.knowledge = knowledge;
    this.watch = watch;
    this.settings = settings;
  }

  @Override
  public Performance perform(Order order, Consumer<Report> reported) {
    Snapshot before = knowledge.snapshot();
    noteSetting(order, before);
    Performance[] performance = new Performance[1];
    performance[0] =
        crew.perform(
            order,
            report -> {
              if (report.succeeded()) {
                done(order, before, performance[0]);
              }
              reported.accept(report);
            });
    return () -> {
      if (!watch.keeps(performance[0])) {
        performance[0].cancel();
      }
    };
  }

  private void done(Order order, Snapshot before, Performance performance) {
    if (watch.concerns(order.step().feature(), knowledge.home())) {
      watch.keep(order.step(), performance, knowledge.snapshot(), knowledge.home());
    } else {
      noteSetting(order, before);
    }
  }

  /**
   * Noted before the call is sent too, so that it is known as the goal's own whoever hears the
   * call's end; a setting that is not made after all is forgotten when settings are compared.
   */
  private void noteSetting(Order order, Snapshot before) {
    if (!order.step().feature().continuous()) {
      settings.done(order.step(), before);
    }
  }

  @Override
  public void callOff(String member, Call call) {
    crew.callOff(member, call);
  }
}
