package org.maestro.random;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.maestro.assembly.AgentlessSite;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.sim.world.World;
import org.maestro.sl.Formula;

/** The heart alone. */
record ArenaWithoutAgents(AgentlessSite site, RandomRun.Onlooker onlooker) implements Arena {

  @Override
  public World world() {
    return site.world();
  }

  @Override
  public InProcessBus bus() {
    return site.bus();
  }

  @Override
  public Clock clock() {
    return site.clock();
  }

  @Override
  public KnowledgeBase knowledge() {
    return site.knowledge();
  }

  @Override
  public void freezeMain(Duration lasting) {
    site.freezeMain(lasting);
  }

  @Override
  public Formula parsed(String goal) {
    return site.parsed(goal);
  }

  @Override
  public void pursue(String goal, Consumer<Claim> ended, Consumer<String> refused) {
    site.pursue(
        goal,
        new Coordinator.Answer() {
          @Override
          public void accepted(String goalId) {
            onlooker.accepted(goalId);
          }

          @Override
          public void refused(String reason) {
            refused.accept(reason);
          }
        },
        outcome -> {
          onlooker.ended(outcome);
          ended.accept(
              new Claim(
                  goal,
                  outcome.reached(),
                  outcome.confirmed(),
                  outcome.binding(),
                  outcome.reasons()));
        });
  }

  @Override
  public void hold(String goal, Consumer<Claim> told) {
    site.hold(
        goal,
        news ->
            told.accept(Claim.ofHeld(goal, news.kind().isSo(), news.confirmed(), news.reasons())));
  }

  @Override
  public boolean runUntil(BooleanSupplier condition, Duration limit) {
    return site.runUntil(condition, limit);
  }

  @Override
  public List<String> story() {
    return site.story().stream().map(ArenaWithoutAgents::line).toList();
  }

  static String line(StoryEntry entry) {
    return String.format(
        Locale.ROOT, "%s %.3f %s", entry.goalId(), entry.at().toNanos() / 1e9, entry.text());
  }

  @Override
  public void close() {
    site.close();
  }
}
