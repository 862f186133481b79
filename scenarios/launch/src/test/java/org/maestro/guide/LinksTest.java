package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.Test;

/** Every link of every page leads somewhere, and every page in docs is led to from README.md. */
class LinksTest {
  private static final Path ROOT = Path.of("../..").toAbsolutePath().normalize();

  @Test
  void leadSomewhere() throws IOException {
    List<String> broken = new ArrayList<>();
    for (Page page : Page.all(ROOT)) {
      for (String link : page.links()) {
        page.objection(link)
            .ifPresent(
                why ->
                    broken.add(
                        "%s links to %s, %s; correct the link."
                            .formatted(ROOT.relativize(page.file()), link, why)));
      }
    }

    assertThat(broken).isEmpty();
  }

  @Test
  void leadFromReadmeToEveryPageOfDocs() throws IOException {
    Set<Path> reached = new TreeSet<>();
    Deque<Path> next = new ArrayDeque<>(List.of(ROOT.resolve("README.md")));
    while (!next.isEmpty()) {
      Path file = next.pop();
      if (reached.add(file)) {
        Page page = Page.read(file);
        page.links().stream()
            .map(page::target)
            .filter(target -> target.toString().endsWith(".md") && Files.exists(target))
            .forEach(next::push);
      }
    }

    List<Path> pages =
        Page.all(ROOT).stream()
            .map(Page::file)
            .filter(file -> file.startsWith(ROOT.resolve("docs")))
            .toList();
    assertThat(pages).hasSizeGreaterThan(50);
    assertThat(pages)
        .filteredOn(file -> !reached.contains(file))
        .extracting(file -> ROOT.relativize(file).toString())
        .as(
            "pages that no link leads to; link each from README.md, or from a page that is linked there")
        .isEmpty();
  }
}
