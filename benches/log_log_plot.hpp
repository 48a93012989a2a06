// Draws curves on logarithmic axes as an SVG file that reads on light and dark pages; one below the other, so that a
// telephone shows them.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

struct Panel {
    std::string title, x_label, y_label;
    std::vector<std::pair<double, double>> points;
    double level = 0; // drawn as a line across, unless 0
    std::string level_label = {};
};

class LogLogPlot {
public:
    // False when the file cannot be written.
    static bool write(const std::string &path, const std::vector<Panel> &panels) {
        std::FILE *file = std::fopen(path.c_str(), "w");
        if (!file) return false;
        std::fprintf(file,
                     "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" font-family=\"DejaVu Sans, sans-serif\" "
                     "font-size=\"13\">\n<rect width=\"100%%\" height=\"100%%\" fill=\"#fff\"/>\n",
                     kWidth, int(panels.size()) * kHeight);
        for (size_t i = 0; i < panels.size(); ++i) LogLogPlot(file, panels[i], double(i) * kHeight).draw();
        std::fprintf(file, "</svg>\n");
        return std::fclose(file) == 0;
    }

private:
    static constexpr int kWidth = 420, kHeight = 320;
    static constexpr double kLeft = 60, kRight = 30, kTop = 35, kBottom = 50;

    LogLogPlot(std::FILE *file, const Panel &panel, double offset) : file_(file), panel_(panel), offset_(offset) {
        for (const auto &[x, y] : panel.points) {
            first_x_ = std::min(first_x_, std::floor(std::log10(x)));
            last_x_ = std::max(last_x_, std::ceil(std::log10(x)));
            first_y_ = std::min(first_y_, std::floor(std::log10(y)));
            last_y_ = std::max(last_y_, std::ceil(std::log10(y)));
        }
        if (panel.level > 0) {
            first_y_ = std::min(first_y_, std::floor(std::log10(panel.level)));
            last_y_ = std::max(last_y_, std::ceil(std::log10(panel.level)));
        }
        last_x_ = std::max(last_x_, first_x_ + 1.0);
        last_y_ = std::max(last_y_, first_y_ + 1.0);
    }

    double x_of(double log_x) const {
        return kLeft + (log_x - first_x_) / (last_x_ - first_x_) * (kWidth - kLeft - kRight);
    }
    double y_of(double log_y) const {
        return offset_ + kHeight - kBottom - (log_y - first_y_) / (last_y_ - first_y_) * (kHeight - kTop - kBottom);
    }

    void line(double x1, double y1, double x2, double y2) const {
        std::fprintf(file_, "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#ccc\"/>\n", x1, y1, x2,
                     y2);
    }
    void text(double x, double y, const std::string &label, const char *more) const {
        std::fprintf(file_, "<text x=\"%.1f\" y=\"%.1f\" %s>%s</text>\n", x, y, more, label.c_str());
    }
    // Raised digits of Unicode: viewers disagree on where a shifted tspan goes.
    static std::string power_of_ten(double exponent) {
        static const char *const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
        std::string label = exponent < 0 ? "10⁻" : "10";
        for (const char digit : std::to_string(std::abs(int(exponent)))) label += digits[digit - '0'];
        return label;
    }

    void draw() const {
        const double left = x_of(first_x_), right = x_of(last_x_), bottom = y_of(first_y_), top = y_of(last_y_);
        for (double e = first_x_; e <= last_x_; ++e) {
            line(x_of(e), bottom, x_of(e), top);
            text(x_of(e), bottom + 18, power_of_ten(e), "text-anchor=\"middle\"");
        }
        for (double e = first_y_; e <= last_y_; ++e) {
            line(left, y_of(e), right, y_of(e));
            text(left - 8, y_of(e) + 5, power_of_ten(e), "text-anchor=\"end\"");
        }
        text(0.5 * kWidth, offset_ + 20, panel_.title, "text-anchor=\"middle\" font-weight=\"bold\"");
        text(0.5 * (left + right), offset_ + kHeight - 10, panel_.x_label, "text-anchor=\"middle\"");
        char turned[80];
        const double x = 15, y = 0.5 * (bottom + top);
        std::snprintf(turned, sizeof turned, "text-anchor=\"middle\" transform=\"rotate(-90 %.1f %.1f)\"", x, y);
        text(x, y, panel_.y_label, turned);
        if (panel_.level > 0) {
            const double y = y_of(std::log10(panel_.level));
            std::fprintf(file_,
                         "<line x1=\"%.1f\" y1=\"%.1f\" x2=\"%.1f\" y2=\"%.1f\" stroke=\"#d55e00\" "
                         "stroke-width=\"2\" stroke-dasharray=\"6 4\"/>\n",
                         left, y, right, y);
            text(0.5 * (left + right), y - 6, panel_.level_label, "text-anchor=\"middle\" fill=\"#d55e00\"");
        }
        curve();
    }

    void curve() const {
        std::fprintf(file_, "<polyline fill=\"none\" stroke=\"#0072b2\" stroke-width=\"2\" points=\"");
        for (const auto &[x, y] : panel_.points)
            std::fprintf(file_, "%.1f,%.1f ", x_of(std::log10(x)), y_of(std::log10(y)));
        std::fprintf(file_, "\"/>\n");
        for (const auto &[x, y] : panel_.points)
            std::fprintf(file_, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"3.5\" fill=\"#0072b2\"/>\n", x_of(std::log10(x)),
                         y_of(std::log10(y)));
    }

    std::FILE *file_;
    const Panel &panel_;
    double offset_;
    double first_x_ = 1e9, last_x_ = -1e9, first_y_ = 1e9, last_y_ = -1e9;
};
