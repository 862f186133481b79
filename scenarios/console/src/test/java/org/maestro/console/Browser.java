package org.maestro.console;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.openqa.selenium.By;
import org.openqa.selenium.JavascriptExecutor;
import org.openqa.selenium.StaleElementReferenceException;
import org.openqa.selenium.WebElement;
import org.openqa.selenium.chrome.ChromeDriver;
import org.openqa.selenium.chrome.ChromeDriverService;
import org.openqa.selenium.chrome.ChromeOptions;
import org.openqa.selenium.support.ui.WebDriverWait;

/** A real browser with the page of a console. */
final class Browser implements AutoCloseable {
  private static final Duration LIMIT = Duration.ofSeconds(60);

  private final ChromeDriver driver;

  private Browser(ChromeDriver driver) {
    this.driver = driver;
  }

  /** Whether this machine has what it takes. */
  static boolean isThere() {
    return program("chromium").isPresent() && program("chromedriver").isPresent();
  }

  private static Optional<Path> program(String name) {
    return Stream.of(System.getenv().getOrDefault("PATH", "").split(":"))
        .map(directory -> Path.of(directory, name))
        .filter(Files::isExecutable)
        .findFirst();
  }

  static Browser open() {
    ChromeOptions options = new ChromeOptions();
    options.setBinary(program("chromium").orElseThrow().toFile());
    options.addArguments(
        "--headless=new",
        "--no-sandbox",
        // A secured site's own authority is none that browsers know.
        "--ignore-certificate-errors",
        "--disable-gpu",
        "--disable-dev-shm-usage");
    ChromeDriverService service =
        new ChromeDriverService.Builder()
            .usingDriverExecutable(program("chromedriver").orElseThrow().toFile())
            .usingAnyFreePort()
            .build();
    return new Browser(new ChromeDriver(service, options));
  }

  void size(int width, int height) {
    driver.executeCdpCommand(
        "Emulation.setDeviceMetricsOverride",
        Map.of("width", width, "height", height, "deviceScaleFactor", 1, "mobile", width < 500));
  }

  /** Goes to the page, and waits until it is told what happens. */
  void go(String address) {
    open(address);
    waitFor("#link.live");
  }

  void open(String address) {
    driver.get(address);
    // Another fragment of the same page would not be another page.
    driver.navigate().refresh();
  }

  /** Of our page: {@code light} or {@code dark}, by its button. */
  void theme(String name) {
    run(
        "if (document.documentElement.dataset.theme !== arguments[0]) {"
            + " document.getElementById('theme').click(); }",
        name);
    waitFor("html[data-theme=" + name + "]");
  }

  /** Another view of the page that is shown, as it stands in the address. */
  void view(String address) {
    run("location.hash = 'view=' + arguments[0]", address);
    waitFor("[data-view=" + address.split("&")[0] + "][aria-pressed=true]");
  }

  WebElement waitFor(String selector) {
    return new WebDriverWait(driver, LIMIT)
        .ignoring(StaleElementReferenceException.class)
        .until(
            shown ->
                shown.findElements(By.cssSelector(selector)).stream().findFirst().orElse(null));
  }

  void waitForText(String selector, String text) {
    new WebDriverWait(driver, LIMIT)
        .ignoring(StaleElementReferenceException.class)
        .withMessage(() -> "\"" + text + "\" in " + text(selector))
        .until(shown -> text(selector).contains(text));
  }

  /** Waits until a variable of the page has the text in it. */
  void waitForSaid(String variable, String text) {
    new WebDriverWait(driver, LIMIT)
        .until(shown -> String.valueOf(run("return " + variable)).contains(text));
  }

  /** All text that is there; what is drawn anew meanwhile is read anew. */
  String text(String selector) {
    return String.valueOf(
        run(
            "return [...document.querySelectorAll(arguments[0])].map(e => e.textContent).join('\\n')",
            selector));
  }

  void click(String selector) {
    run(
        "document.querySelector(arguments[0]).dispatchEvent(new MouseEvent('click', {bubbles: true}))",
        selector);
  }

  Object run(String script, Object... arguments) {
    return ((JavascriptExecutor) driver).executeScript(script, arguments);
  }

  Object runAsync(String script, Object... arguments) {
    return ((JavascriptExecutor) driver).executeAsyncScript(script, arguments);
  }

  String address() {
    return String.valueOf(driver.getCurrentUrl());
  }

  /** What the page has complained of. */
  List<String> complaints() {
    return driver.manage().logs().get("browser").getAll().stream()
        .map(entry -> entry.getMessage())
        .toList();
  }

  @Override
  public void close() {
    driver.quit();
  }
}
