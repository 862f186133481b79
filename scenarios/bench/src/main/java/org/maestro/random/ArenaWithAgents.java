package org.maestro.random;

import java.time.Duration;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import org.maestro.assembly.LocalSite;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.rats.time.Clock;
import org.maestro.rats.transport.Disturbance;
import org.maestro.rats.transport.InProcessBus;
import org.maestro.rats.transport.Publication;
import org.maestro.sim.world.World;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;

/** The whole platform with its agents. */
final class ArenaWithAgents implements Arena {
  private static final String CONTROLLER = "maestro";

  private final LocalSite site;
  private final List<String> story = new CopyOnWriteArrayList<>();

  /** Agents report on threads of their own; it is told where time passes. */
  private final Queue<Runnable> reports = new ConcurrentLinkedQueue<>();

  ArenaWithAgents(LocalSite site) {
    this.site = site;
    site.platform().onStory(entry -> story.add(ArenaWithoutAgents.line(entry)));
  }

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
    return site.platform().knowledge();
  }

  /** Of agents, each on a thread of its own, only what they hear and say can be held up. */
  @Override
  public void freezeMain(Duration lasting) {
    Duration end = clock().now().plus(lasting);
    bus().disturb(new Frozen(clock(), end));
    clock().schedule(lasting, "freeze", () -> bus().disturb(Disturbance.NONE));
  }

  private record Frozen(Clock clock, Duration end) implements Disturbance {
    @Override
    public List<Copy> published(String client, Publication publication) {
      return List.of(new Copy(publication, heardLater(client)));
    }

    @Override
    public Duration heardLater(String client) {
      Duration left = end.minus(clock.now());
      return client.equals(CONTROLLER) && !left.isNegative() ? left : Duration.ZERO;
    }
  }

  @Override
  public Formula parsed(String goal) {
    return SlParser.formula(goal, site.platform().knowledge().home().vocabulary()::isFluent);
  }

  @Override
  public void pursue(String goal, Consumer<Claim> ended, Consumer<String> refused) {
    site.platform()
        .desk()
        .pursue(
            parsed(goal),
            id -> {},
            report ->
                reports.add(
                    () ->
                        ended.accept(
                            new Claim(
                                goal,
                                report.reached(),
                                report.confirmed(),
                                report.binding(),
                                report.reasons()))));
  }

  @Override
  public void hold(String goal, Consumer<Claim> told) {
    site.platform()
        .desk()
        .hold(
            parsed(goal),
            report ->
                reports.add(
                    () ->
                        told.accept(
                            Claim.ofHeld(
                                goal, report.isSo(), report.confirmed(), report.reasons()))));
  }

  @Override
  public boolean runUntil(BooleanSupplier condition, Duration limit) {
    return site.runUntil(
        () -> {
          for (Runnable report = reports.poll(); report != null; report = reports.poll()) {
            report.run();
          }
          return condition.getAsBoolean();
        },
        limit);
  }

  @Override
  public List<String> story() {
    return List.copyOf(story);
  }

  @Override
  public void close() {
    site.close();
  }
}
