import { chromium } from "playwright-core";
const [file, prefix, width, dark] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath: "/usr/bin/chromium", args: ["--no-sandbox", "--disable-gpu"] });
const page = await browser.newPage({ viewport: { width: Number(width), height: 1000 }, colorScheme: dark ? "dark" : "light" });
page.on("console", (m) => console.log("console", m.type(), m.text()));
page.on("pageerror", (e) => console.log("error", e.message));
await page.goto("file://" + file);
const height = await page.evaluate(() => document.documentElement.scrollHeight);
console.log("height", height, "scrollWidth", await page.evaluate(() => document.documentElement.scrollWidth));
const piece = Number(process.env.PIECE || 2000);
for (let k = 0, y = 0; y < height; ++k, y += piece)
  await page.screenshot({ path: `${prefix}${k}.png`, fullPage: true, clip: { x: 0, y, width: Number(width), height: Math.min(piece, height - y) } });
await browser.close();
