package org.maestro.console;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;

/** The rules by which a page is for everybody: contrast, labels, roles. */
final class Accessibility {
  private Accessibility() {}

  /**
   * Asserts that the page that is shown is for everybody, wide and dark, and narrow and light; wide
   * again in the end.
   *
   * @param text to wait for in what the selector finds
   */
  static void assertForEverybody(Browser browser, String selector, String text) throws IOException {
    for (String theme : List.of("light", "dark")) {
      browser.size(theme.equals("dark") ? 1440 : 390, 844);
      browser.theme(theme);
      browser.waitForText(selector, text);
      assertThat(faults(browser)).as(theme).isEmpty();
      assertThat(browser.run("return document.documentElement.scrollWidth <= innerWidth"))
          .as("nothing is cut off, " + theme)
          .isEqualTo(true);
    }
  }

  /** What the page that is shown breaks of them. */
  static List<?> faults(Browser browser) throws IOException {
    try (InputStream axe = Accessibility.class.getResourceAsStream("/axe.min.js")) {
      browser.run(new String(Objects.requireNonNull(axe).readAllBytes(), StandardCharsets.UTF_8));
    }
    return (List<?>)
        browser.runAsync(
            "const done = arguments[0];"
                + " axe.run().then(found => done(found.violations.map(fault =>"
                + " fault.id + ': ' + fault.nodes.map(node => node.html).join(' '))));");
  }
}
