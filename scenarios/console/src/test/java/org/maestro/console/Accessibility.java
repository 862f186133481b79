package org.maestro.console;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Objects;

/** The rules by which a page is for everybody: contrast, labels, roles. */
final class Accessibility {
  private Accessibility() {}

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
