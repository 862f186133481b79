package org.maestro.experiment.page;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import org.maestro.experiment.drawing.Figure;
import org.maestro.experiment.setting.Settings;
import org.maestro.text.VisibleText;

/** Is written from top to bottom. For one thread. */
public final class Page {
  private static final String STYLE =
      """
      body { font: 17px/1.5 sans-serif; color: #222; max-width: 1060px; margin: 2em auto; padding: 0 1em; }
      h1 { font-size: 1.7em; } h2 { font-size: 1.25em; margin-top: 2em; }
      table { border-collapse: collapse; width: 100%; margin: 1em 0; }
      th, td { border: 1px solid #bbb; padding: .35em .6em; text-align: left; vertical-align: top; }
      th { background: #eee; } figure { margin: 1.5em 0; } img { max-width: 100%; border: 1px solid #ddd; }
      figcaption { color: #444; font-size: .95em; } code { background: #f3f3f3; padding: 0 .2em; }
      """;

  private static final String TITLE_END = "</h1>\n";

  private final StringBuilder body = new StringBuilder();
  private final String title;

  /**
   * @param lead what the experiment shows, and the command that repeats it
   */
  public Page(String title, String lead, String command) {
    this.title = title;
    body.append("<h1>").append(escaped(title)).append(TITLE_END);
    text(lead);
    body.append("<p>To repeat it: <code>").append(escaped(command)).append("</code></p>\n");
  }

  /**
   * A row of the comparison with the paper: what is compared, what the paper says of it, what was
   * measured here, and what to know.
   */
  public record Row(String what, String paper, String here, String remark) {}

  /** What has to be known before anything else, below the title. */
  public Page notice(String text) {
    body.insert(
        body.indexOf(TITLE_END) + TITLE_END.length(),
        "<p><strong>" + escaped(text) + "</strong></p>\n");
    return this;
  }

  public Page heading(String text) {
    body.append("<h2>").append(escaped(text)).append("</h2>\n");
    return this;
  }

  public Page text(String text) {
    body.append("<p>").append(escaped(text)).append("</p>\n");
    return this;
  }

  public Page comparison(List<Row> rows) {
    return table(
        List.of("", "paper", "measured here", "remark"),
        rows.stream()
            .map(row -> List.of(row.what(), row.paper(), row.here(), row.remark()))
            .toList());
  }

  /** Of no rows, it says so instead. */
  public Page table(List<String> columns, List<List<String>> rows) {
    if (rows.isEmpty()) {
      return text("None.");
    }
    body.append("<table>\n<tr>");
    columns.forEach(cell -> body.append("<th>").append(escaped(cell)).append("</th>"));
    body.append("</tr>\n");
    for (List<String> row : rows) {
      body.append("<tr>");
      row.forEach(cell -> body.append("<td>").append(escaped(cell)).append("</td>"));
      body.append("</tr>\n");
    }
    body.append("</table>\n");
    return this;
  }

  public Page list(List<String> items) {
    body.append("<ul>\n");
    items.forEach(item -> body.append("<li>").append(escaped(item)).append("</li>\n"));
    body.append("</ul>\n");
    return this;
  }

  public Page figure(Figure figure) {
    body.append("<figure><img alt=\"")
        .append(escaped(figure.caption()))
        .append("\" src=\"data:image/png;base64,")
        .append(Base64.getEncoder().encodeToString(figure.png()))
        .append("\"><figcaption>")
        .append(escaped(figure.caption()))
        .append("</figcaption></figure>\n");
    return this;
  }

  /** What was set, and what else could be. */
  public Page settings(Settings settings) {
    heading("What can be set");
    return table(
        List.of("--set", "here", "usual", "meaning"),
        settings.known().stream()
            .map(
                setting ->
                    List.of(
                        setting.name(),
                        settings.value(setting),
                        setting.usual(),
                        setting.meaning()))
            .toList());
  }

  public String html() {
    return """
    <!DOCTYPE html>
    <html lang="en">
    <head><meta charset="utf-8"><title>%s</title><style>
    %s</style></head>
    <body>
    %s</body>
    </html>
    """
        .formatted(escaped(title), STYLE, body);
  }

  public void write(Path file) {
    try {
      Files.write(file, html().getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException("The page " + file + " cannot be written.", e);
    }
  }

  private static String escaped(String text) {
    return VisibleText.line(text)
        .replace("&", "&amp;")
        .replace("<", "&lt;")
        .replace(">", "&gt;")
        .replace("\"", "&quot;");
  }
}
