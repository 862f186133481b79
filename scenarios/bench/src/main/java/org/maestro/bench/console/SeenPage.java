package org.maestro.bench.console;

import com.fasterxml.jackson.databind.JsonNode;
import java.net.URI;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.maestro.bench.Waiting;

/** The console's page as it is seen: when it is there, what a thing on its map is said to be. */
final class SeenPage {
  private static final int WIDTH = 1440;
  private static final int HEIGHT = 900;

  /** Notes when the map is there and live, and each new word of the thing that is watched. */
  private static final String NOTES =
      """
      window.seen = { loaded: null, thing: null, last: null, texts: [], longest: 0 };
      const millis = () => performance.timeOrigin + performance.now();
      const look = () => {
        if (seen.loaded === null && document.querySelector("#link.live") && document.querySelector("#plan .thing")) {
          seen.loaded = performance.now();
        }
        const text = seen.thing && document.querySelector(`[data-thing="${seen.thing}"]`)?.getAttribute("aria-label");
        if (text && text !== seen.last) {
          seen.last = text;
          seen.texts.push([text, millis()]);
        }
      };
      new MutationObserver(look).observe(document, { subtree: true, childList: true, attributes: true });
      new PerformanceObserver((list) => list.getEntries().forEach((task) => {
        seen.longest = Math.max(seen.longest, task.duration);
      })).observe({ entryTypes: ["longtask"] });
      """;

  private static final String FRAMES =
      """
      (watched) => new Promise((done) => {
        const between = [];
        const begin = performance.now();
        let last = begin;
        seen.longest = 0;
        const frame = (now) => {
          between.push(now - last);
          last = now;
          if (now - begin < watched) { requestAnimationFrame(frame); } else { done({ between, longest: seen.longest }); }
        };
        requestAnimationFrame(frame);
      })
      """;

  /**
   * How smoothly it moved.
   *
   * @param millis between one frame and the next, each
   * @param longestTaskMillis what the page did in one go; zero when nothing took 50 ms
   */
  record Frames(List<Double> millis, double longestTaskMillis) {}

  private final DevTools page;

  SeenPage(DevTools page) {
    this.page = page;
    page.send("Page.enable");
    page.size(WIDTH, HEIGHT);
    page.beforeEachPage(NOTES);
  }

  /** From the order to go there until the map is drawn and told what happens. */
  double loadMillis(URI address) {
    page.go(URI.create("about:blank"));
    Waiting.until(() -> page.value("location.href").asText().equals("about:blank"), "it is left");
    page.go(address);
    Waiting.until(
        () -> page.value("window.seen ? seen.loaded : null").isNumber(), "the map is drawn");
    return page.value("seen.loaded").asDouble();
  }

  void show(String view) {
    page.value("location.hash = 'view=%s'".formatted(view));
  }

  /** From now on what the map says of the thing is noted. */
  void watch(String thing) {
    page.value("seen.thing = '%s'; seen.last = null; seen.texts = []; 0".formatted(thing));
  }

  /**
   * The time at which the map said of it for the last time what contains this, in milliseconds
   * since 1970; NaN if it has not.
   */
  double seenAtMillis(String text) {
    JsonNode at =
        page.value(
            "(seen.texts.filter(([text]) => text.includes('%s')).at(-1) ?? [null, null])[1]"
                .formatted(text));
    return at.isNumber() ? at.asDouble() : Double.NaN;
  }

  void forget() {
    page.value("seen.texts = []; 0");
  }

  Frames frames(Duration watched) {
    JsonNode told = page.value("(" + FRAMES + ")(" + watched.toMillis() + ")");
    List<Double> between = new ArrayList<>();
    told.path("between").forEach(each -> between.add(each.asDouble()));
    return new Frames(between, told.path("longest").asDouble());
  }

  /** What the page holds, without its garbage. */
  double heapMiB() {
    page.send("HeapProfiler.collectGarbage");
    return page.value("performance.memory.usedJSHeapSize").asDouble() / (1 << 20);
  }

  /** How many elements it has. */
  int elements() {
    return page.value("document.querySelectorAll('*').length").asInt();
  }
}
