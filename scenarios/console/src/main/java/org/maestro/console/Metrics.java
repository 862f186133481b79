package org.maestro.console;

import com.fasterxml.jackson.databind.JsonNode;
import io.javalin.http.Context;
import io.micrometer.core.instrument.MultiGauge;
import io.micrometer.core.instrument.Tags;
import io.micrometer.core.instrument.Timer;
import io.micrometer.core.instrument.binder.jvm.ClassLoaderMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmGcMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmMemoryMetrics;
import io.micrometer.core.instrument.binder.jvm.JvmThreadMetrics;
import io.micrometer.core.instrument.binder.system.FileDescriptorMetrics;
import io.micrometer.core.instrument.binder.system.ProcessorMetrics;
import io.micrometer.core.instrument.binder.system.UptimeMetrics;
import io.micrometer.prometheusmetrics.PrometheusConfig;
import io.micrometer.prometheusmetrics.PrometheusMeterRegistry;
import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.stream.StreamSupport;
import org.maestro.agents.pulse.Condition;
import org.maestro.console.questions.Questions;
import org.maestro.coordination.api.StoryEntry;

/**
 * What the platform and its process do, in figures for who gathers them (ADE, A34): goals, members
 * and containers by their states when it is asked, what has happened since the start, and how soon
 * the API answers. In the text form of Prometheus. Any thread may use it.
 */
final class Metrics implements AutoCloseable {
  private static final String TEXT = "text/plain; version=0.0.4; charset=utf-8";
  private static final List<StoryEntry.Kind> BEGUN =
      List.of(StoryEntry.Kind.GOAL, StoryEntry.Kind.RESTART);

  private final PrometheusMeterRegistry registry =
      new PrometheusMeterRegistry(PrometheusConfig.DEFAULT);
  private final JvmGcMetrics collections = new JvmGcMetrics();
  private final Map<String, Duration> begun = new ConcurrentHashMap<>();
  private final Questions questions;
  private final Supplier<? extends Map<String, Condition>> containers;
  private final Consumer<Duration> answered;
  private final MultiGauge goalsByState;
  private final MultiGauge membersByPhase;
  private final MultiGauge containersByCondition;

  /**
   * @param containers of the platform, and whether they give signs of life
   * @param answered told how long the API takes to answer
   */
  Metrics(
      Questions questions,
      Supplier<? extends Map<String, Condition>> containers,
      Consumer<Duration> answered) {
    this.questions = questions;
    this.answered = answered;
    this.containers = containers;
    this.goalsByState = gauge("maestro.goals", "The goals that are listed, by their state.");
    this.membersByPhase = gauge("maestro.members", "The members, by their phase on the bus.");
    this.containersByCondition =
        gauge("maestro.containers", "The containers, by whether they give signs of life.");
    Stream.of(
            new JvmMemoryMetrics(),
            new JvmThreadMetrics(),
            new ClassLoaderMetrics(),
            new ProcessorMetrics(),
            new FileDescriptorMetrics(),
            new UptimeMetrics(),
            collections)
        .forEach(part -> part.bindTo(registry));
  }

  private MultiGauge gauge(String name, String description) {
    return MultiGauge.builder(name).description(description).register(registry);
  }

  /** A sentence of a story. */
  void told(StoryEntry entry) {
    registry
        .counter("maestro.story.entries", "kind", entry.kind().name().toLowerCase(Locale.ROOT))
        .increment();
    if (BEGUN.contains(entry.kind())) {
      begun.putIfAbsent(entry.goalId(), entry.at());
    } else if (entry.kind() == StoryEntry.Kind.END) {
      Optional.ofNullable(begun.remove(entry.goalId()))
          .ifPresent(since -> goals().record(entry.at().minus(since)));
    }
  }

  private Timer goals() {
    return Timer.builder("maestro.goal.duration")
        .description("Simulated time from a goal's statement to its end.")
        .register(registry);
  }

  /** An operation was answered. */
  void answered(String operation, int status, Duration after) {
    Timer.builder("maestro.console.requests")
        .description("How long the API takes to answer, by operation.")
        .tags("operation", operation, "status", String.valueOf(status))
        .register(registry)
        .record(after);
    answered.accept(after);
  }

  /** What cannot be asked now, as there is no coordinator, is left out. */
  CompletableFuture<?> tell(Context context) {
    return show(goalsByState, questions.goals(), "goals", "state")
        .thenCompose(shown -> show(membersByPhase, questions.agents(), "agents", "phase"))
        .thenAccept(
            shown -> {
              show(
                  containersByCondition,
                  "condition",
                  containers.get().values().stream()
                      .map(condition -> condition.name().toLowerCase(Locale.ROOT)));
              context.contentType(TEXT).result(registry.scrape());
            });
  }

  private static CompletableFuture<?> show(
      MultiGauge gauge, CompletableFuture<JsonNode> asked, String rows, String tag) {
    return asked.handle(
        (document, failure) -> {
          Stream<JsonNode> all =
              failure != null
                  ? Stream.of()
                  : StreamSupport.stream(document.path(rows).spliterator(), false);
          show(
              gauge,
              tag,
              all.map(row -> row.path(tag)).filter(JsonNode::isTextual).map(JsonNode::asText));
          return gauge;
        });
  }

  private static void show(MultiGauge gauge, String tag, Stream<String> values) {
    gauge.register(
        values
            .collect(Collectors.groupingBy(Function.identity(), Collectors.counting()))
            .entrySet()
            .stream()
            .map(each -> MultiGauge.Row.of(Tags.of(tag, each.getKey()), each.getValue()))
            .collect(Collectors.toList()),
        true);
  }

  @Override
  public void close() {
    collections.close();
    registry.close();
  }
}
