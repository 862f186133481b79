package org.maestro.bench.console;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteException;
import org.maestro.bench.Waiting;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.transport.PahoTransport;

/**
 * A lamp that is set by another controller, whose end of the bus hears when the lamp tells of it.
 */
final class SetLamp implements AutoCloseable {
  private static final String LAMP = "lamp-a1";
  private static final List<Double> LEVELS = List.of(0.25, 0.5, 1.0, 0.0);
  private static final long PATIENCE_SECONDS = 30;

  private final RatsLink link;

  SetLamp(LocalSite site, String name) {
    String client = name + "-witness";
    this.link =
        BusLink.connect(
            "bench-witness",
            name,
            new PahoTransport(site.broker().orElseThrow(), client),
            site.clock());
    Waiting.until(
        () -> link.members().stream().anyMatch(member -> member.id().equals(LAMP)),
        "the lamp is on the bus");
  }

  /** How long the map took to show, each time, what the lamp had told on the bus. */
  List<Double> millisUntilSeen(SeenPage page, int times) {
    page.watch(LAMP);
    List<Double> millis = new ArrayList<>();
    for (int time = 0; time < times; time++) {
      double level = LEVELS.get(time % LEVELS.size());
      String shown = Math.round(100 * level) + " %";
      page.forget();
      double told = set(level);
      Waiting.until(() -> page.seenAtMillis(shown) > 0, "the map says " + shown);
      millis.add(page.seenAtMillis(shown) - told);
    }
    return millis;
  }

  /** Returns when its state told of it, in milliseconds since 1970. */
  private double set(double level) {
    CompletableFuture<Double> told = new CompletableFuture<>();
    String value = "(= (level %s) %s)".formatted(LAMP, level);
    Runnable end =
        link.watch(
            LAMP,
            member ->
                member
                    .state()
                    .filter(state -> state.values().stream().anyMatch(one -> says(one, level)))
                    .ifPresent(state -> told.complete(now())));
    link.call(
        LAMP,
        "adjustLight",
        Map.of("level", level),
        Duration.ofSeconds(PATIENCE_SECONDS),
        Optional.empty(),
        SetLamp::ended);
    try {
      return told.get(PATIENCE_SECONDS, TimeUnit.SECONDS);
    } catch (TimeoutException | ExecutionException e) {
      throw new SiteException("The lamp does not tell " + value + ".", e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new SiteException("Interrupted while a lamp was set.", e);
    } finally {
      end.run();
    }
  }

  private static void ended(Result result) {
    // What counts is what its state tells.
  }

  private static boolean says(String value, double level) {
    String start = "(= (level " + LAMP + ") ";
    return value.startsWith(start)
        && Double.parseDouble(value.substring(start.length(), value.length() - 1)) == level;
  }

  private static double now() {
    return System.currentTimeMillis();
  }

  @Override
  public void close() {
    link.close();
  }
}
